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

  /// Calls visit(index) for every box that meets `box`, in an order that depends on the boxes
  /// alone.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const {
    if (!nodes_.empty()) descend(0, box, visit);
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< leaf: range of items_; inner node: the second child
    std::uint32_t count = 0;  ///< of a leaf; 0: inner node, whose first child comes next
  };

  std::uint32_t build(std::span<const Box> boxes, std::uint32_t first, std::uint32_t last);

  template <class Visit>
  void descend(std::uint32_t k, const Box& box, Visit& visit) const {
    const Node& node = nodes_[k];
    if (!node.box.meets(box)) return;
    if (node.count == 0) {
      descend(k + 1, box, visit);
      descend(node.first, box, visit);
      return;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (boxes_[items_[i]].meets(box)) visit(items_[i]);
    }
  }

  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
};

}  // namespace cover
