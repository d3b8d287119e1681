#include "limits/region_limits.hpp"

#include <gtest/gtest.h>

#include <random>

#include <cover/judged_angle.hpp>

#include "cdt/cdt.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using namespace testing;

const ReachedAngles kWanted{Angle::degrees(80), Angle::degrees(20)};

Triangulation region_cdt_of(const Loop& loop) {
  const RegionBoundary boundary = boundary_of({loop});
  return triangulate_domain(boundary.points, boundary.sides).triangulation;
}

ReachedAngles reached(double largest, double smallest) {
  return {Angle::degrees(180 - largest), Angle::degrees(smallest)};
}

TEST(RegionLimits, ATargetIsMetButForRounding) {
  const Angle target = Angle::degrees(20);
  EXPECT_TRUE(meets(target, target));
  EXPECT_TRUE(meets(Angle::radians(target.in_radians() - 0.9e-9), target));
  EXPECT_FALSE(meets(Angle::radians(target.in_radians() - 1.1e-9), target));
  EXPECT_TRUE(meets(reached(100 + 1e-8, 20 - 1e-8), reached(100, 20)));
  EXPECT_FALSE(meets(reached(100 + 1e-6, 20), reached(100, 20)));
}

TEST(RegionLimits, ATriangleIsOptimal) {
  const Triangulation cdt = region_cdt_of({{0, 0}, {1, 0}, {0.1, 0.1}});
  const double largest = 180 - 45 - std::atan2(0.1, 0.9) * 180 / std::numbers::pi;
  const RegionLimits limits =
      region_limits(cdt, reached(largest, std::atan2(0.1, 0.9) * 180 / std::numbers::pi), kWanted);
  EXPECT_EQ(limits.of_largest, Standing::optimal);
  EXPECT_EQ(limits.of_smallest, Standing::optimal);
}

TEST(RegionLimits, StandingsFollowTheGap) {
  // 10 long and 1 high: no triangle on a long side has all angles above 11.31 degrees.
  const Triangulation cdt = region_cdt_of({{0, 0}, {10, 0}, {10, 1}, {0, 1}});
  const RegionLimits near = region_limits(cdt, reached(100, 10.8), kWanted);
  EXPECT_EQ(near.of_largest, Standing::met);
  EXPECT_TRUE(near.of_smallest == Standing::near || near.of_smallest == Standing::optimal);
  EXPECT_GE(near.smallest.in_degrees(), 10.8);
  EXPECT_LE(near.smallest.in_degrees(), 11.8 + 1e-9);
  EXPECT_NEAR(near.under.in_degrees(), 80, 1e-9);
  EXPECT_EQ(region_limits(cdt, reached(100, 0.1), kWanted).of_smallest, Standing::open);
  EXPECT_EQ(region_limits(cdt, reached(100, 20), kWanted).of_smallest, Standing::met);
  EXPECT_EQ(region_limits(cdt, reached(170, 5), kWanted).of_largest, Standing::open);
}

TEST(RegionLimits, LittleEffortProvesNoMoreThanAll) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 40; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(12, 0.6, random)});
    const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
    const ReachedAngles angles = reached(100, 1);
    const RegionLimits all = region_limits(cdt, angles, kWanted);
    const RegionLimits brief = region_limits(cdt, angles, kWanted, {}, ProofEffort::brief());
    EXPECT_GE(brief.smallest.in_radians(), all.smallest.in_radians() - 1e-12);
    EXPECT_GE(brief.smallest.in_degrees(), 1);
  }
}

TEST(RegionLimits, WhatCouplingsForbidIsToldAsSuch) {
  // The half discs of the long sides hold all of the rectangle: no vertex is in a coupled mesh.
  const Triangulation cdt = region_cdt_of({{0, 0}, {4, 0}, {4, 1}, {0, 1}});
  LimitProver prover(cdt);
  const auto limits = [&](Meshes meshes) {
    const double smallest = std::atan2(1, 4) * 180 / std::numbers::pi;
    return region_limits(prover, reached(150, smallest), kWanted, {}, {}, meshes);
  };
  EXPECT_EQ(limits(Meshes::all).of_smallest, Standing::open);
  EXPECT_EQ(limits(Meshes::coupled).of_smallest, Standing::coupled);
  EXPECT_NEAR(limits(Meshes::coupled).smallest.in_degrees(), 14.036, 1.001);
}

TEST(RegionLimits, StandingsHaveNames) {
  EXPECT_STREQ(describe(Standing::optimal), "optimal");
  EXPECT_STREQ(describe(Standing::unknown), "unknown");
}

}  // namespace
}  // namespace cover
