// Threads of the standard library alone: pools that queue functions allocate for each, and end the
// process when that fails in a worker.
// Tested by tests/unit/tasks/run_all_test.cpp.
#include "tasks/run_all.hpp"

#include <algorithm>
#include <atomic>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace cover {

void run_all(std::size_t count, unsigned workers, const std::function<void(std::size_t)>& run) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&next, &run, count] {
    for (std::size_t k = next++; k < count; k = next++) run(k);
  };
  const std::size_t others = std::min<std::size_t>(workers, count);
  std::vector<std::jthread> threads;
  if (others > 1) threads.reserve(others - 1);
  try {
    while (threads.size() + 1 < others) threads.emplace_back(work);
  } catch (const std::system_error&) {
    // Those that there are do all of it.
  } catch (const std::bad_alloc&) {
  }
  work();
}

}  // namespace cover
