// Sets that are united step by step.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace cover {

/// The numbers below n, each a set of its own at first.
///
/// Cost: O(log n) a call on average.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// The smallest number of the set of i.
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// The same for several threads, which may call everything at a time. What the sets are, and with
/// them their smallest numbers, does not depend on the order of calls.
///
/// Ref: jayanti_tarjan_2016_concurrent, where links go to the smaller number
class SharedUnionFind {
 public:
  explicit SharedUnionFind(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  /// The smallest number of the set of i, as long as no call of unite() concerns that set.
  std::uint32_t find(std::uint32_t i) {
    for (;;) {
      std::uint32_t parent = load(i);
      if (parent == i) return i;
      const std::uint32_t above = load(parent);
      if (above != parent)  // if that fails, another thread has shortened the way
        std::atomic_ref(parent_[i]).compare_exchange_weak(parent, above, kOrder);
      i = above;
    }
  }

  void unite(std::uint32_t i, std::uint32_t j) {
    for (;;) {
      i = find(i);
      j = find(j);
      if (i == j) return;
      if (i < j) std::swap(i, j);
      std::uint32_t expected = i;
      if (std::atomic_ref(parent_[i]).compare_exchange_strong(expected, j, kOrder)) return;
    }
  }

 private:
  /// Numbers are all that threads tell each other here.
  static constexpr std::memory_order kOrder = std::memory_order_relaxed;

  std::uint32_t load(std::uint32_t i) { return std::atomic_ref(parent_[i]).load(kOrder); }

  std::vector<std::uint32_t> parent_;
};

}  // namespace cover
