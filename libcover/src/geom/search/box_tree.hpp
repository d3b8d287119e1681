// Which boxes meet a box: a static binary tree over axis-parallel boxes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/box.hpp"

namespace cover {

/// Built once, asked often.
class BoxTree {
 public:
  BoxTree() = default;
  /// Cost: O(n log n)
  explicit BoxTree(std::span<const Box> boxes);

  /// Calls visit(index) for every box that `shape` meets, in an order that depends on the boxes
  /// alone. The shape is a Box, or has its meets(), true of a box around one that it meets.
  template <class Shape, class Visit>
  void visit(const Shape& shape, Visit&& visit) const {
    if (!nodes_.empty()) descend(0, shape, visit);
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< leaf: range of items_; inner node: the second child
    std::uint32_t count = 0;  ///< of a leaf; 0: inner node, whose first child comes next
  };

  std::uint32_t build(std::span<const Box> boxes, std::uint32_t first, std::uint32_t last);

  template <class Shape, class Visit>
  void descend(std::uint32_t k, const Shape& shape, Visit& visit) const {
    const Node& node = nodes_[k];
    if (!shape.meets(node.box)) return;
    if (node.count == 0) {
      descend(k + 1, shape, visit);
      descend(node.first, shape, visit);
      return;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (shape.meets(boxes_[items_[i]])) visit(items_[i]);
    }
  }

  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
};

}  // namespace cover
