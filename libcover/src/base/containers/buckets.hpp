// Items sorted by a small key.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cover {

/// Items by a small key, each list in the order of the items.
class Buckets {
 public:
  /// `key(k)` of each item k below `items` is below `keys`.
  template <class Key>
  Buckets(std::size_t keys, std::size_t items, Key key) : first_(keys + 1), items_(items) {
    for (std::size_t k = 0; k < items; ++k) ++first_[key(k) + 1];
    for (std::size_t b = 0; b < keys; ++b) first_[b + 1] += first_[b];
    std::vector<std::size_t> next(first_);
    for (std::size_t k = 0; k < items; ++k) items_[next[key(k)]++] = k;
  }
  [[nodiscard]] std::size_t size() const { return first_.size() - 1; }
  [[nodiscard]] std::span<const std::size_t> operator[](std::size_t b) const {
    return std::span(items_).subspan(first_[b], first_[b + 1] - first_[b]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::size_t> items_;
};

}  // namespace cover
