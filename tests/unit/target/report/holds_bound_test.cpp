// Triangles that are at a bound, and where rounding decides.
#include "target/report/holds_bound.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cover {
namespace {

TEST(HoldsBound, UpToTheRoundingOfTheCoordinates) {
  // nu = 2 * 2^-30 with coordinates near 2^20: a unit in the last place is 2^-32.
  const double x = 0x1p20, height = 0x1p-30;
  const std::vector<Point> points{{x, x}, {x + 2, x}, {x + 1, x + height}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}};
  EXPECT_TRUE(holds_bound(points, triangles, Angle::radians(2.4 * height)));
  EXPECT_FALSE(holds_bound(points, triangles, Angle::radians(6 * height)));
  const std::vector<Point> at_origin{{0, 0}, {2, 0}, {1, height}};
  EXPECT_FALSE(holds_bound(at_origin, triangles, Angle::radians(2.4 * height)));
}

TEST(HoldsBound, OfNoTriangles) { EXPECT_TRUE(holds_bound({}, {}, Angle::degrees(20))); }

TEST(CountAbove, ATriangleAtTheAngleIsNotAboveIt) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}};
  EXPECT_EQ(count_above(points, triangles, Angle::degrees(90)), 0U);
  EXPECT_EQ(count_above(points, triangles, Angle::degrees(89.9)), 1U);
}

}  // namespace
}  // namespace cover
