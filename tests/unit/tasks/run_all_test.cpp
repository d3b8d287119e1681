#include "tasks/run_all.hpp"

#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(RunAll, CallsEachOnceWithAnyNumberOfWorkers) {
  for (const unsigned workers : {0U, 1U, 2U, 7U, 100U}) {
    for (const std::size_t count : {0U, 1U, 2U, 50U}) {
      std::vector<std::atomic<int>> calls(count);
      run_all(count, workers, [&](std::size_t k) { ++calls[k]; });
      for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(calls[k], 1) << k << " of " << count;
    }
  }
}

TEST(RunAll, OneWorkerIsTheCaller) {
  std::vector<std::size_t> order;
  const std::thread::id caller = std::this_thread::get_id();
  run_all(3, 1, [&](std::size_t k) {
    order.push_back(k);
    EXPECT_EQ(std::this_thread::get_id(), caller);
  });
  EXPECT_EQ(order, std::vector<std::size_t>({0, 1, 2}));
}

TEST(RunAll, SeveralWorkAtATime) {
  // The first waits for the second, which needs a thread of its own.
  std::atomic<bool> second_began = false;
  std::mutex mutex;
  std::set<std::thread::id> threads;
  run_all(2, 2, [&](std::size_t k) {
    if (k == 1) second_began = true;
    while (!second_began) std::this_thread::yield();
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(threads.size(), 2U);
}

}  // namespace
}  // namespace cover
