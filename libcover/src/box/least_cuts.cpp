// A piece from x to y has an obstacle at (t, h) in its disk just where x < t < y and
// (t - x)(y - t) > h^2, that is where y > t + h^2 / (t - x). A piece of a right piece is right, so
// the longest right piece each time leaves the least to do.
// Tested by tests/unit/box/least_cuts_test.cpp.
#include "box/least_cuts.hpp"

#include <algorithm>

#include "base/numbers.hpp"

namespace cover {
namespace {

/// Where a piece from `start` on must end; the farthest that rounding of the obstacle may make of
/// it, as the expression is convex in t.
double end_before(const Obstacle& o, double start) {
  const double near = o.along - kObstacleRounding, far = o.along + kObstacleRounding;
  if (!(near > start)) return kInfinity;
  const double height = o.height + kObstacleRounding;
  const double end =
      std::max(near + height * height / (near - start), far + height * height / (far - start));
  return end + kObstacleRounding * end;
}

}  // namespace

double longest_piece(std::span<const Obstacle> obstacles, double start, std::size_t first) {
  double end = 1;
  for (std::size_t k = first; k < obstacles.size() && obstacles[k].along < end; ++k) {
    end = std::min(end, end_before(obstacles[k], start));
  }
  return end;
}

std::size_t least_cuts(std::span<const Obstacle> obstacles) {
  std::size_t cuts = 0, first = 0;
  for (double start = longest_piece(obstacles, 0, 0); start < 1; ++cuts) {
    while (first < obstacles.size() && obstacles[first].along <= start) ++first;
    start = longest_piece(obstacles, start, first);
  }
  return cuts;
}

}  // namespace cover
