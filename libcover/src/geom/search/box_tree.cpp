// Halved at the median of the longer direction.
// Tested by tests/unit/layers/front/guards_test.cpp.
#include "geom/search/box_tree.hpp"

#include <numeric>

#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr std::uint32_t kLeaf = 4;  ///< boxes at most

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes)
    : boxes_(boxes.begin(), boxes.end()), items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0U);
  if (!items_.empty()) build(boxes_, 0, static_cast<std::uint32_t>(items_.size()));
}

std::uint32_t BoxTree::build(std::span<const Box> boxes, std::uint32_t first, std::uint32_t last) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box all;
  for (std::uint32_t i = first; i < last; ++i) {
    all.include(boxes[items_[i]]);
  }
  nodes_[at].box = all;
  if (last - first <= kLeaf) {
    nodes_[at].first = first;
    nodes_[at].count = last - first;
    return at;
  }
  const bool by_x = all.high.x - all.low.x >= all.high.y - all.low.y;
  const auto place = [&](std::uint32_t item) {
    const Point m = midpoint(boxes[item].low, boxes[item].high);
    return std::pair(by_x ? m.x : m.y, item);
  };
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last,
                   [&](std::uint32_t i, std::uint32_t j) { return place(i) < place(j); });
  build(boxes, first, middle);
  nodes_[at].first = build(boxes, middle, last);
  return at;
}

}  // namespace cover
