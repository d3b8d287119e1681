// Progress of many threads, told by one at a time.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <stop_token>
#include <string_view>
#include <system_error>
#include <thread>

#include <cover/progress.hpp>

namespace cover {

/// Counts what is done and tells the caller, one thread at a time: whenever something is done, and
/// as often as kPause while nothing is, so that the caller can stop what takes long. Time decides
/// nothing else. What the caller's function throws is kept for the caller's thread.
class ProgressCount {
 public:
  /// REQUIRES: `callbacks` outlives this
  ProgressCount(std::string_view stage, std::size_t total, const Callbacks& callbacks)
      : callbacks_(callbacks), state_{stage, 0, total} {
    if (!callbacks_.progress) return;
    try {
      again_ = std::jthread([this](const std::stop_token& end) { tell_again(end); });
    } catch (const std::system_error&) {  // no thread to be had: it is told less often
    }
  }

  /// Threads: any
  void add(std::size_t cost) {
    if (!callbacks_.progress) return;
    const std::lock_guard lock(mutex_);
    state_.done += cost;
    tell();
  }

  /// Whether the caller wants no more.
  ///
  /// Threads: any
  [[nodiscard]] bool must_stop() const { return has_thrown_ || callbacks_.stop.stop_requested(); }
  /// Tells no more, and throws what the caller's function has thrown.
  ///
  /// Threads: the caller's, when the others are done
  void rethrow() {
    again_ = {};
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  static constexpr std::chrono::milliseconds kPause{200};

  /// REQUIRES: mutex_ is held
  void tell() {
    if (thrown_) return;
    try {
      callbacks_.progress(state_);
    } catch (...) {
      thrown_ = std::current_exception();
      has_thrown_ = true;
    }
  }

  void tell_again(const std::stop_token& end) {
    std::unique_lock lock(mutex_);
    while (!wakes_.wait_for(lock, end, kPause, [&] { return end.stop_requested(); }))
      if (!callbacks_.stop.stop_requested()) tell();
  }

  const Callbacks& callbacks_;
  std::mutex mutex_;  ///< of all that follows but has_thrown_
  Progress state_;
  std::exception_ptr thrown_;
  std::atomic<bool> has_thrown_ = false;
  std::condition_variable_any wakes_;
  std::jthread again_;  ///< the last: it ends before what it uses
};

}  // namespace cover
