// Progress of many threads.
#pragma once

#include <cstddef>
#include <mutex>
#include <string_view>

#include <cover/progress.hpp>

namespace cover {

/// Counts what is done of a stage, and tells it.
class ProgressCount {
 public:
  /// REQUIRES: `callbacks` are those of a FollowedRun, and outlive this
  ProgressCount(std::string_view stage, std::size_t total, const Callbacks& callbacks)
      : callbacks_(callbacks), state_{stage, 0, total} {}

  /// Threads: any
  void add(std::size_t cost) {
    if (!callbacks_.progress) return;
    const std::lock_guard lock(mutex_);  // what is told grows
    state_.done += cost;
    callbacks_.progress(state_);
  }

 private:
  const Callbacks& callbacks_;
  std::mutex mutex_;  ///< of what follows
  Progress state_;
};

}  // namespace cover
