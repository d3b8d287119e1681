// Which lines come near a point: a static tree of turned boxes.
#pragma once

#include <vector>

#include "disks/packing/disk.hpp"

namespace cover::disks {

/// A binary tree over the lines of a packing.
///
/// Its boxes are turned to the main direction of their lines. Axis-parallel boxes around a bundle
/// of slanting needles would all overlap, and every query would visit the whole bundle.
class LineTree {
 public:
  LineTree() = default;
  /// Builds the tree over the elements that are lines; `from` and `to` must be final.
  explicit LineTree(const std::vector<Element>& elements);

  /// Calls visit(element) -> double for lines that may be nearer to `x` than `bound`; the value
  /// returned is the new bound. Near boxes first.
  template <class Visit>
  void visit(Point x, double bound, Visit&& visit) const {
    if (!nodes_.empty()) descend(0, x, bound, visit);
  }

 private:
  struct Node {
    Point centre;
    Vector axis;  ///< unit
    double half_along = 0;
    double half_across = 0;
    Index first = 0;  ///< leaf: range of lines_; inner node: the second child
    Index count = 0;  ///< lines of a leaf; 0: inner node, whose first child comes next
  };

  Index build(const std::vector<Element>& elements, Index first, Index last);
  [[nodiscard]] static double distance(const Node& n, Point x);

  template <class Visit>
  double descend(Index k, Point x, double bound, Visit& visit) const {
    const Node& n = nodes_[k];
    if (n.count != 0) {
      for (Index i = n.first; i < n.first + n.count; ++i) bound = visit(lines_[i]);
      return bound;
    }
    const double left = distance(nodes_[k + 1], x), right = distance(nodes_[n.first], x);
    const bool left_first = left <= right;
    if ((left_first ? left : right) < bound) {
      bound = descend(left_first ? k + 1 : n.first, x, bound, visit);
    }
    if ((left_first ? right : left) < bound) {
      bound = descend(left_first ? n.first : k + 1, x, bound, visit);
    }
    return bound;
  }

  std::vector<Node> nodes_;
  std::vector<Index> lines_;
};

}  // namespace cover::disks
