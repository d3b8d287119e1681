#include "target/angle_limit.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "region/region_boundary.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

AngleLimit limit_of(const RegionBoundary& boundary) {
  const CdtResult cdt = triangulate_domain(boundary.points, boundary.sides);
  EXPECT_TRUE(cdt.conflicts.empty());
  return angle_limit(cdt.triangulation, boundary.sides, boundary.segments);
}

TEST(AngleLimit, OfATriangleIsItsLargestAngle) {
  const AngleLimit limit = limit_of(testing::boundary_of({{{0, 0}, {2, 0}, {1, 1}}}));
  EXPECT_DOUBLE_EQ(limit.nu, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(limit.promised_nu(), std::numbers::pi / 6);
  EXPECT_EQ(limit.above_120, 0U);
}

TEST(AngleLimit, OfARegularPolygonIsTheInscribedAngle) {
  const AngleLimit limit = limit_of(testing::boundary_of({testing::regular_polygon(100)}));
  for (const double nu : limit.side_nu)
    EXPECT_NEAR(std::numbers::pi - nu, std::numbers::pi / 100, 1e-12);
}

TEST(AngleLimit, SeesSlitsFromBothSides) {
  // A slit along the x axis, a point close above it.
  const auto boundary =
      testing::boundary_of({{{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, {{-1, 0}, {1, 0}}}, {{0, 0.125}});
  const AngleLimit limit = limit_of(boundary);
  EXPECT_NEAR(limit.nu, 2 * std::atan(0.125), 1e-15);
  EXPECT_EQ(limit.above_150, 1U);
  const auto worst = std::min_element(limit.side_nu.begin(), limit.side_nu.end());
  const auto& [from, to] = boundary.sides[static_cast<std::size_t>(worst - limit.side_nu.begin())];
  EXPECT_EQ(boundary.points[from], (Point{-1, 0}));
  EXPECT_EQ(boundary.points[to], (Point{1, 0}));
}

TEST(AngleLimit, CountsAnglesOf120DegreesExactly) {
  // 1/sqrt(3) is no double, so the apex is put on either side of the arc.
  const double h = 1 / std::sqrt(3.0);
  for (const double ulp : {-1.0, 1.0}) {
    const Point apex{0, h + ulp * 0x1p-52};
    const AngleLimit limit = limit_of(testing::boundary_of({{{-1, 0}, {1, 0}, apex}}));
    EXPECT_EQ(limit.above_120, ulp < 0 ? 1U : 0U);
  }
}

TEST(AngleLimit, IsAccurateForFlatTriangles) {
  // Exact by construction: apex 2^-40 above the middle of a side of length 2 that does not start at
  // the origin; the differences of the coordinates need more bits than a double has.
  const double gap = 0x1p-40;
  const AngleLimit limit =
      limit_of(testing::boundary_of({{{-1, 1 / 3.0}, {1, 1 / 3.0}, {0, 1 / 3.0 + gap}}}));
  EXPECT_NEAR(limit.nu / (2 * gap), 1, 1e-4);  // 1/3 + gap is rounded to 2^-54
  EXPECT_NEAR(accurate_nu_at({-1, 0}, {0x1p-60, gap}, {1, 0}) / (2 * gap), 1, 1e-15);
}

TEST(AngleLimit, HullSidesHaveNone) {
  auto boundary = testing::boundary_of({{{-1, 0}, {1, 0}, {0, 0.125}}});
  for (std::size_t s = 0; s < 3; ++s) {
    if (boundary.sides[s] == IndexPair{0, 2}) boundary.segments[s] = kHullSide;
  }
  const AngleLimit limit = limit_of(boundary);
  EXPECT_GT(limit.nu, 3);
  EXPECT_EQ(limit.above_120, 0U);
}

}  // namespace
}  // namespace cover
