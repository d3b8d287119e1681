// Tested by tests/unit/layers/front/layer_front_test.cpp.
#include "layers/front/side_links.hpp"

#include <algorithm>

#include "geom/predicates.hpp"

namespace cover::layers {
namespace {

/// Where a point lies around `b`, clockwise from `a`: before, at and after the half turn; at `a`.
int clockwise_sector(Point b, Point a, Point p) {
  const Sign side = orientation(b, a, p);
  if (side == Sign::negative) return 0;
  if (side == Sign::positive) return 2;
  return dot(a - b, p - b) < 0 ? 1 : 3;
}

bool is_before_clockwise(Point b, Point a, Point p, Point q) {
  const int of_p = clockwise_sector(b, a, p), of_q = clockwise_sector(b, a, q);
  return of_p != of_q ? of_p < of_q : orientation(b, p, q) == Sign::negative;
}

}  // namespace

std::vector<std::uint32_t> next_sides(const RegionBoundary& boundary) {
  const auto& [points, sides] = std::tie(boundary.points, boundary.sides);
  std::vector<std::uint32_t> next;
  next.reserve(sides.size());
  for (const auto& [a, b] : sides) {
    const auto first = std::lower_bound(sides.begin(), sides.end(), IndexPair{b, 0});
    auto best = first;
    for (auto side = first; side != sides.end() && (*side)[0] == b; ++side) {
      if (is_before_clockwise(points[b], points[a], points[(*side)[1]], points[(*best)[1]]))
        best = side;
    }
    next.push_back(static_cast<std::uint32_t>(best - sides.begin()));
  }
  return next;
}

Vector unit_normal(Point a, Point b) {
  const Vector n = left_normal(b - a);
  return (1 / length(n)) * n;
}

}  // namespace cover::layers
