// Threads of the standard library alone: pools that queue functions allocate for each, and end the
// process when that fails in a worker.
// Tested by tests/unit/base/run_all_test.cpp.
#include "base/run_all.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace cover {
namespace {

/// One call of Team::each(), on the stack of whoever made it.
struct Parts {
  std::size_t count;
  const std::function<void(std::size_t)>& run;
  std::size_t next = 0;
  std::size_t working = 0;
  std::exception_ptr thrown{};
  std::size_t thrown_by = std::numeric_limits<std::size_t>::max();
  Parts* older = nullptr;  ///< of those that have parts nobody has begun
};

/// Nobody waits for something that is not being worked on: whoever calls each() works on its own
/// parts first, and then waits for those that others have begun, which end in the same way.
class Pool final : public Crew {
 public:
  Pool(std::size_t count, unsigned workers,
       const std::function<void(std::size_t, const Team&)>& run)
      : count_(count), workers_(std::max(workers, 1U)), run_(run) {
    if (workers_ > 1) threads_.reserve(workers_ - 1);
  }

  void work() {
    hire(count_);
    std::unique_lock lock(mutex_);
    take_calls(lock);
    lock.unlock();
    threads_.clear();
  }

  [[nodiscard]] unsigned workers() const override { return workers_; }

  void each(std::size_t count, const std::function<void(std::size_t)>& run) override {
    hire(count);
    Parts parts{count, run};
    std::unique_lock lock(mutex_);
    parts.older = open_;
    open_ = &parts;
    changed_.notify_all();
    while (parts.next < parts.count) run_part(parts, lock);
    changed_.wait(lock, [&] { return parts.working == 0; });
    if (parts.thrown) std::rethrow_exception(parts.thrown);
  }

 private:
  /// Threads for as much to do at a time, the caller with them.
  void hire(std::size_t at_a_time) {
    const std::lock_guard lock(hiring_);
    const std::size_t others = std::min<std::size_t>(workers_, at_a_time);
    try {
      while (threads_.size() + 1 < others) {
        threads_.emplace_back([this] {
          std::unique_lock own(mutex_);
          take_calls(own);
        });
      }
    } catch (const std::system_error&) {
      // Those that there are do all of it.
    } catch (const std::bad_alloc&) {
    }
  }

  /// Works on parts, and else on calls, until all are done.
  ///
  /// REQUIRES: `lock` is held, before and after
  void take_calls(std::unique_lock<std::mutex>& lock) {
    while (finished_ < count_) {
      if (open_ != nullptr) {
        run_part(*open_, lock);
      } else if (next_ < count_) {
        const std::size_t k = next_++;
        lock.unlock();
        run_(k, Team(*this));
        lock.lock();
        if (++finished_ == count_) changed_.notify_all();
      } else {
        changed_.wait(lock);
      }
    }
  }

  /// REQUIRES: as take_calls(), and parts.next < parts.count
  void run_part(Parts& parts, std::unique_lock<std::mutex>& lock) {
    const std::size_t k = parts.next++;
    if (parts.next == parts.count) close(parts);
    ++parts.working;
    lock.unlock();
    std::exception_ptr thrown;
    try {
      parts.run(k);
    } catch (...) {
      thrown = std::current_exception();
    }
    lock.lock();
    if (thrown && k < parts.thrown_by) {
      if (parts.next < parts.count) close(parts);
      parts.next = parts.count;
      parts.thrown = thrown;
      parts.thrown_by = k;
    }
    if (--parts.working == 0) changed_.notify_all();
  }

  void close(const Parts& parts) {
    Parts** place = &open_;
    while (*place != &parts) place = &(*place)->older;
    *place = parts.older;
  }

  const std::size_t count_;
  const unsigned workers_;
  const std::function<void(std::size_t, const Team&)>& run_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0, finished_ = 0;
  Parts* open_ = nullptr;
  std::mutex hiring_;
  std::vector<std::jthread> threads_;
};

}  // namespace

unsigned worker_count(unsigned threads) {
  return threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

void run_all(std::size_t count, unsigned workers,
             const std::function<void(std::size_t, const Team&)>& run) {
  if (workers < 2) {
    for (std::size_t k = 0; k < count; ++k) run(k, Team());
  } else {
    Pool(count, workers, run).work();
  }
}

void run_all(std::size_t count, unsigned workers, const std::function<void(std::size_t)>& run) {
  run_all(count, workers, [&run](std::size_t k, const Team&) { run(k); });
}

}  // namespace cover
