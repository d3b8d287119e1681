#include "box/least_cuts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "box/forced_cuts.hpp"
#include "cdt/cdt.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

Obstacle at(double along, double height) { return {along, height, {}}; }

TEST(LeastCuts, AreNoneWithoutObstacles) {
  EXPECT_EQ(least_cuts({}), 0U);
  const std::vector<Obstacle> outside{at(0.5, 0.51)};
  EXPECT_EQ(least_cuts(outside), 0U);
}

TEST(LeastCuts, OneObstacleNeedsOne) {
  for (const double height : {1e-9, 1e-3, 0.1, 0.49}) {
    const std::vector<Obstacle> one{at(0.5, height)};
    EXPECT_EQ(least_cuts(one), 1U) << height;
    EXPECT_NEAR(longest_piece(one, 0, 0), 0.5 + 2 * height * height, 1e-13);
  }
}

TEST(LeastCuts, OfARowOfLowObstaclesIsOneForEach) {
  std::vector<Obstacle> row;
  for (int k = 1; k < 10; ++k) row.push_back(at(0.1 * k, 0.01));
  EXPECT_EQ(least_cuts(row), 9U);
  for (Obstacle& o : row) o.height = 0.06;  // a piece over one of them has room to its neighbours
  // From the left: cuts at 0.136, 0.256, 0.382, 0.531, 0.652, 0.775 and 0.929.
  EXPECT_EQ(least_cuts(row), 7U);
  EXPECT_EQ(least_cuts(turned_round(row)), 7U);
}

TEST(LeastCuts, ADimpleUnderALongLidNeedsAsManyAsThereMustBe) {
  // Two points over the bottom: both sides of an interface count together.
  const RegionBoundary boundary =
      testing::boundary_of({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, {{3, 1}, {7, 1}});
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  std::vector<std::vector<EncroachedSegment>> regions{encroached_segments(boundary, cdt)};
  // The upright sides have the points on their circles, not inside.
  ASSERT_EQ(regions[0].size(), 1U);
  const ForcedCuts forced = forced_cuts(regions);
  EXPECT_EQ(forced.segments, 1U);
  EXPECT_EQ(forced.least, 2U);  // behind each point, at 3.33 and 7.27
}

}  // namespace
}  // namespace cover
