// Progress of many threads, told by one at a time.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string_view>

#include <cover/progress.hpp>

namespace cover {

/// Counts what is done and tells the caller, one thread at a time. What the caller's function
/// throws is kept for the caller's thread.
class ProgressCount {
 public:
  /// REQUIRES: `callbacks` outlives this
  ProgressCount(std::string_view stage, std::size_t total, const Callbacks& callbacks)
      : callbacks_(callbacks), state_{stage, 0, total} {}

  /// Threads: any
  void add(std::size_t cost) {
    if (!callbacks_.progress) return;
    const std::lock_guard lock(mutex_);
    state_.done += cost;
    if (thrown_) return;
    try {
      callbacks_.progress(state_);
    } catch (...) {
      thrown_ = std::current_exception();
      has_thrown_ = true;
    }
  }

  /// Whether the caller wants no more.
  ///
  /// Threads: any
  [[nodiscard]] bool must_stop() const { return has_thrown_ || callbacks_.stop.stop_requested(); }
  /// Throws what the caller's function has thrown.
  ///
  /// Threads: the caller's, when the others are done
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const Callbacks& callbacks_;
  std::mutex mutex_;
  Progress state_;
  std::exception_ptr thrown_;
  std::atomic<bool> has_thrown_ = false;
};

}  // namespace cover
