// A priority queue that only tells orders of magnitude apart.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cover {

/// Entries in buckets, the lowest bucket first; within a bucket first in, first out. So what was
/// put in one after the other, and lies together in memory, is taken out in that order.
template <class T>
class BucketQueue {
 public:
  /// Puts `entry` into bucket `bucket`, or the nearest there is.
  void push(int bucket, const T& entry) {
    const auto b = static_cast<std::size_t>(std::clamp(bucket, 0, kBuckets - 1));
    buckets_[b].entries.push_back(entry);
    first_ = std::min(first_, b);
  }

  [[nodiscard]] bool empty() {
    while (first_ < kBuckets && buckets_[first_].head == buckets_[first_].entries.size()) {
      buckets_[first_++] = {};
    }
    return first_ == kBuckets;
  }

  /// The bucket of the next entry.
  /// REQUIRES: empty() has just said no
  [[nodiscard]] int first() const { return static_cast<int>(first_); }

  /// REQUIRES: as first()
  T pop() {
    Bucket& bucket = buckets_[first_];
    return bucket.entries[bucket.head++];
  }

 private:
  static constexpr int kBuckets = 128;
  struct Bucket {
    std::vector<T> entries;
    std::size_t head = 0;
  };
  std::array<Bucket, kBuckets> buckets_;
  std::size_t first_ = kBuckets;
};

/// Two buckets per factor of two, from 1 on: the exponent and the first bit after it.
///
/// REQUIRES: x >= 0
inline int half_octave(double x) {
  constexpr int kOne = static_cast<int>(std::bit_cast<std::uint64_t>(1.0) >> 51);
  return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 51) - kOne;
}

}  // namespace cover
