#include "limits/angles/angles_around.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "cdt/cdt.hpp"
#include "geom/vector.hpp"
#include "limits/region_limits.hpp"
#include "support/inputs/random_regions.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(AnglesAround, AreThoseOfTheTrianglesAtAVertex) {
  // A right angle at 1 and at 2, three of 45 degrees, one of 135 at 0.
  const std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {-1, 2}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}, {0, 2, 3}};
  const AnglesAround around = AnglesAround::of(points, triangles, 3);
  ASSERT_EQ(around.most_cot.size(), 3U);
  EXPECT_NEAR(around.most_cot[1], 1, 1e-12);  // 45 degrees
  EXPECT_NEAR(around.least_cot[1], 0, 1e-12);
  const double sharp = angle_at(points[2], points[3], points[0]);
  EXPECT_NEAR(around.most_cot[0], std::max(1.0, 1 / std::tan(sharp)), 1e-12);
  EXPECT_EQ(around.most_cot[0], around.most_cot[2]);
  EXPECT_EQ(around.least_near[1], around.least_cot[0]);  // a neighbour's
}

// Sides beside which a mesh has no angle out of the range settle nothing: with all sides asked the
// answers are the same.
TEST(AnglesAround, TakeAwayNoProof) {
  std::mt19937_64 random(7);
  const ReachedAngles wanted{Angle::degrees(80), Angle::degrees(20)};
  int missed = 0;
  for (int k = 0; k < 200; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(8 + k % 9, 0.5, random)});
    const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
    std::vector<IndexTriple> triangles;
    ReachedAngles reached{Angle::degrees(180), Angle::degrees(60)};
    for (const Triangle& t : cdt.triangles) {
      triangles.push_back(t.v);
      for (const Corner i : kCorners) {
        const double angle =
            angle_at(cdt.points[t.v[i.next()]], cdt.points[t.v[i]], cdt.points[t.v[i.previous()]]);
        reached.largest_nu =
            std::min(reached.largest_nu, Angle::degrees(180 - angle * 180 / std::numbers::pi));
        reached.smallest = std::min(reached.smallest, Angle::radians(angle));
      }
    }
    const ProofEffort much{1'000'000, 1'000'000, 20'000, 16};
    const RegionLimits all = region_limits(cdt, reached, wanted, {}, much);
    const RegionLimits some = region_limits(
        cdt, reached, wanted, {}, much, AnglesAround::of(cdt.points, triangles, cdt.points.size()));
    EXPECT_EQ(all.of_largest, some.of_largest) << k;
    EXPECT_EQ(all.of_smallest, some.of_smallest) << k;
    missed += all.of_smallest != Standing::met ? 1 : 0;
  }
  EXPECT_GT(missed, 100);
}

}  // namespace
}  // namespace cover
