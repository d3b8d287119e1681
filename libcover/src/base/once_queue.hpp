// Work that waits in line, each piece once at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cover {

/// Numbers, first in first out. What waits already is not put in again.
///
/// Cost: O(1) a call on average; 4 bytes for every number put in, and one for each up to the
///       largest
class OnceQueue {
 public:
  OnceQueue() = default;
  /// For numbers below `end`; others may come.
  explicit OnceQueue(std::size_t end) : waits_(end, 0) { queue_.reserve(std::min(end, kFew)); }

  [[nodiscard]] bool empty() const { return head_ == queue_.size(); }
  [[nodiscard]] std::size_t size() const { return queue_.size() - head_; }

  void push(std::uint32_t i) {
    if (waits_.size() <= i) waits_.resize(std::size_t{i} + 1, 0);
    if (waits_[i] != 0) return;
    waits_[i] = 1;
    queue_.push_back(i);
  }

  /// REQUIRES: not empty
  std::uint32_t pop() {
    const std::uint32_t i = queue_[head_++];
    waits_[i] = 0;
    return i;
  }

 private:
  static constexpr std::size_t kFew = 1'024;
  std::vector<std::uint32_t> queue_;
  std::size_t head_ = 0;
  std::vector<std::uint8_t> waits_;  ///< by number
};

}  // namespace cover
