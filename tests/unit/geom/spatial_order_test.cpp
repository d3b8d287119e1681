#include "geom/spatial_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geom/vector.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

std::vector<Point> grid(int n) {
  std::vector<Point> points;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  return points;
}

TEST(SpatialOrder, IsAPermutation) {
  for (const int n : {0, 1, 2, 3, 10}) {
    std::vector<std::uint32_t> order = spatial_order(grid(n));
    std::sort(order.begin(), order.end());
    for (std::uint32_t k = 0; k < order.size(); ++k) EXPECT_EQ(order[k], k);
    EXPECT_EQ(order.size(), static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  }
}

TEST(SpatialOrder, KeepsNeighboursTogether) {
  const std::vector<Point> points = grid(128);
  const std::vector<std::uint32_t> order = spatial_order(points);
  double way = 0;
  for (std::size_t k = 1; k < order.size(); ++k)
    way += length(points[order[k]] - points[order[k - 1]]);
  EXPECT_LT(way,
            1.5 * static_cast<double>(points.size()));  // 1 at least; in columns a bit more than 1
  // A quarter of the points in a row fills about a quarter of the square, not half of it.
  const auto quarter = points.size() / 4;
  double left = 128, right = 0;
  for (std::size_t k = 0; k < quarter; ++k) {
    left = std::min(left, points[order[k]].x);
    right = std::max(right, points[order[k]].x);
  }
  EXPECT_LT(right - left, 80);
}

TEST(SpatialOrder, IsTheSameInAnyUnitAndPlace) {
  std::mt19937_64 random(7);
  std::vector<Point> points = testing::random_star(500, 0.3, random);
  std::sort(points.begin(), points.end());
  const auto order = spatial_order(points);
  for (Point& p : points) p = {std::ldexp(p.x, -30), std::ldexp(p.y, -30)};
  EXPECT_EQ(spatial_order(points), order);
}

}  // namespace
}  // namespace cover
