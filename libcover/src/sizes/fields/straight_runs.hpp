// The outline of a region without what only cuts its sides.
#pragma once

#include <span>
#include <vector>

#include <cover/point.hpp>

#include "cdt/cdt.hpp"

namespace cover {

/// Points, and the directed sides between them.
struct Outline {
  std::vector<Point> points;
  std::vector<IndexPair> sides;
};

/// A region's boundary, whose runs of sides along a straight line are one side each: what lies
/// between their ends is no farther from it than `tolerance`. Points on no side stay, and so do
/// those where more than two sides meet.
///
/// A triangulation of it has no fans of needles to cuts that are close to each other. Where a
/// region is hardly wider than the tolerance, sides may meet or enclose nothing.
///
/// REQUIRES: tolerance > 0; sides as RegionBoundary::sides
/// Cost:     O(n)
Outline with_straight_runs_joined(std::span<const Point> points, std::span<const IndexPair> sides,
                                  double tolerance);

}  // namespace cover
