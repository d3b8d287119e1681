// Which disks come near a point: a growing quadtree.
#pragma once

#include <array>
#include <vector>

#include "disks/packing/disk.hpp"

namespace cover::disks {

/// A quadtree of disks over the square [0, 1] x [0, 1]. A disk sits in the cell that holds its
/// centre, at the depth where cells are about as large as the disk. Disks of a packing do not
/// overlap, so a cell holds only a few of them whatever their number.
class DiskTree {
 public:
  DiskTree() : nodes_(1) {}

  void insert(const Element& disk, Index element);

  /// Calls visit(element) -> double for disks that may be nearer to `x` than `bound`; the value
  /// returned is the new bound. Near cells first.
  template <class Visit>
  void visit(Point x, double bound, Visit&& visit) const {
    descend(0, {0.5, 0.5}, 0.5, x, bound, visit);
  }

 private:
  struct Node {
    std::array<Index, 4> child{kNone, kNone, kNone, kNone};
    Index first = kNone;  ///< list of items
  };
  struct Item {
    Index element = 0;
    Index next = kNone;
  };

  static Point child_centre(Point centre, double half, unsigned quadrant);
  /// Lower bound of the distance from `x` to disks with centres in a square of half width `half`
  /// and radii up to `half`.
  static double distance(Point centre, double half, Point x);

  template <class Visit>
  double descend(Index k, Point centre, double half, Point x, double bound, Visit& visit) const {
    const Node& n = nodes_[k];
    for (Index i = n.first; i != kNone; i = items_[i].next) bound = visit(items_[i].element);
    const unsigned nearest = (x.x >= centre.x ? 1U : 0U) | (x.y >= centre.y ? 2U : 0U);
    for (unsigned step = 0; step < 4; ++step) {
      const unsigned quadrant = nearest ^ step;
      const Index child = n.child[quadrant];
      if (child == kNone) continue;
      const Point c = child_centre(centre, half, quadrant);
      if (distance(c, half / 2, x) < bound) bound = descend(child, c, half / 2, x, bound, visit);
    }
    return bound;
  }

  std::vector<Node> nodes_;
  std::vector<Item> items_;
};

}  // namespace cover::disks
