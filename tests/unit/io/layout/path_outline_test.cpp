#include "io/layout/path_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/inputs/soups.hpp"

namespace cover {
namespace {

using Points = std::vector<Point>;

WidePath path(Points line, double half_width) {
  WidePath p;
  p.line = std::move(line);
  p.half_width = half_width;
  return p;
}

/// The area of what is painted.
double painted(const std::vector<Points>& polygons) {
  Input input;
  for (const Points& ring : polygons)
    input.polygons.push_back({{ring}, "m", "m", std::nullopt, 0, {}});
  const auto out = testing::clean(input);
  EXPECT_TRUE(out);
  return out ? out->area("m") : 0;
}

TEST(PathPolygons, FollowsTheAxesExactly) {
  const auto polygons = path_polygons(path({{0, 0}, {5, 0}, {10, 0}, {10, 7}}, 1));
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_EQ(polygons[0], (Points{{0, 1}, {9, 1}, {9, 7}, {11, 7}, {11, -1}, {0, -1}}));
}

TEST(PathPolygons, EndsAsItIsTold) {
  WidePath straight = path({{0, 0}, {10, 0}}, 1);
  straight.begin = 2;
  straight.end = 3;
  EXPECT_DOUBLE_EQ(painted(path_polygons(straight)), 15 * 2);
  straight = path({{0, 0}, {10, 0}}, 1);
  straight.round = true;
  straight.step = 1;
  EXPECT_NEAR(painted(path_polygons(straight)), 20 + std::numbers::pi, 1e-3);
}

TEST(PathPolygons, CutsOffSharpCorners) {
  const auto polygons = path_polygons(path({{0, 0}, {10, 0}, {0, 1}}, 0.2));
  for (const Points& ring : polygons)
    for (const Point p : ring) EXPECT_LT(p.x, 10.5);
}

TEST(PathPolygons, CoversWhatCrossesItself) {
  // A loop; a hairpin shorter than it is wide; there and back.
  EXPECT_NEAR(painted(path_polygons(path({{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, -5}}, 1))),
              2 * 11 + 2 * 10 + 2 * 5 + 2 * 14 - 4, 1e-12);
  EXPECT_NEAR(painted(path_polygons(path({{0, 0}, {10, 0}, {10, 1}, {0, 1}}, 1))), 11 * 3, 1e-12);
  EXPECT_NEAR(painted(path_polygons(path({{0, 0}, {10, 0}, {2, 0}}, 1))), 20, 1e-12);
}

}  // namespace
}  // namespace cover
