// A set of numbers that is emptied at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cover {

/// Numbers below some size, each with a stamp of when it was put in: those whose stamp is old are
/// not in the set. So a search that sees little of a large mesh pays for no more than that.
class StampedSet {
 public:
  explicit StampedSet(std::size_t size = 0) : stamp_(size, 0) {}

  /// From now on it may have the numbers below `size`.
  void resize(std::size_t size) { stamp_.resize(size, 0); }
  void reserve(std::size_t size) { stamp_.reserve(size); }

  void clear() {
    if (++now_ != 0) return;
    std::fill(stamp_.begin(), stamp_.end(), 0);  // stamps of 2^32 searches ago would count
    now_ = 1;
  }
  [[nodiscard]] bool contains(std::uint32_t k) const { return stamp_[k] == now_; }
  void insert(std::uint32_t k) { stamp_[k] = now_; }

 private:
  std::vector<std::uint32_t> stamp_;
  std::uint32_t now_ = 1;
};

}  // namespace cover
