// Tested by tests/unit/disks/packing/packing_test.cpp.
#include "disks/packing/search/disk_tree.hpp"

#include <algorithm>
#include <cmath>

namespace cover::disks {

void DiskTree::insert(const Element& disk, Index element) {
  Point centre{0.5, 0.5};
  double half = 0.5;
  Index k = 0;
  constexpr double kSmallest = 0x1p-60;
  while (half / 2 >= disk.r && half > kSmallest) {
    const unsigned quadrant = (disk.c.x >= centre.x ? 1U : 0U) | (disk.c.y >= centre.y ? 2U : 0U);
    if (nodes_[k].child[quadrant] == kNone) {
      nodes_[k].child[quadrant] = static_cast<Index>(nodes_.size());
      nodes_.emplace_back();
    }
    centre = child_centre(centre, half, quadrant);
    k = nodes_[k].child[quadrant];
    half /= 2;
  }
  items_.push_back({element, nodes_[k].first});
  nodes_[k].first = static_cast<Index>(items_.size() - 1);
}

Point DiskTree::child_centre(Point centre, double half, unsigned quadrant) {
  const double step = half / 2;
  return {centre.x + ((quadrant & 1U) != 0 ? step : -step),
          centre.y + ((quadrant & 2U) != 0 ? step : -step)};
}

double DiskTree::distance(Point centre, double half, Point x) {
  const double dx = std::max(std::abs(x.x - centre.x) - half, 0.0);
  const double dy = std::max(std::abs(x.y - centre.y) - half, 0.0);
  return std::sqrt(dx * dx + dy * dy) - half;
}

}  // namespace cover::disks
