// What is proven before anything is searched.
#include "quality/plan/outlook.hpp"

#include <cmath>

#include "../mesh_checks.hpp"
#include "unit/quality/plan/planned_region.hpp"

namespace cover {
namespace {

using namespace testing;

using Seen = PlannedRegion;

TEST(Outlook, HalfDiscsOverTheSidesLeaveNoRoomInATriangleAndSomeInAHexagon) {
  Seen triangle(boundary_of({regular_polygon(3)})), hexagon(boundary_of({regular_polygon(6)}));
  EXPECT_FALSE(triangle.make.outlook().has_no_room()) << "nobody asked";
  triangle.make.look_for_room(triangle.cdt);
  hexagon.make.look_for_room(hexagon.cdt);
  EXPECT_TRUE(triangle.make.outlook().has_no_room());
  EXPECT_FALSE(hexagon.make.outlook().has_no_room());
  triangle.make.outlook().forget_room();
  EXPECT_FALSE(triangle.make.outlook().has_no_room());
}

TEST(Outlook, WhereCouplingsComeLastThereIsAlwaysRoom) {
  Options options;
  options.couplings = Couplings::last;
  Seen triangle(boundary_of({regular_polygon(3)}), options);
  triangle.make.look_for_room(triangle.cdt);
  EXPECT_FALSE(triangle.make.outlook().has_no_room());
}

TEST(Outlook, AHullSideMayBeSplitSoNothingIsProven) {
  RegionBoundary boundary = boundary_of({regular_polygon(3)});
  boundary.segments[0] = kHullSide;
  Seen triangle(boundary);
  triangle.make.look_for_room(triangle.cdt);
  EXPECT_FALSE(triangle.make.outlook().has_no_room());
  EXPECT_FALSE(triangle.make.outlook().is_near_limits(triangle.cdt));
}

TEST(Outlook, ATriangleBetweenTwoSidesIsAsGoodAsAnyAndAFanIsNot) {
  // Sides that meet under 10 degrees, 30 times as long as the third: there is nothing to choose.
  const double turn = 10 * std::numbers::pi / 180;
  Seen needle(boundary_of({{{0, 0}, {1, 0}, {std::cos(turn), std::sin(turn)}}}));
  Seen fan(boundary_of({regular_polygon(20)}));
  EXPECT_FALSE(fan.make.outlook().is_near_limits(fan.cdt));
  EXPECT_FALSE(fan.make.outlook().is_settled(fan.cdt, fan.make.goal()));
  (void)needle;
}

TEST(Outlook, WhatMissesTheLargestAngleIsNeverSettled) {
  Seen fan(boundary_of({regular_polygon(20)}));
  ASSERT_GT(fan.cdt.merit.large, fan.make.goal().large);
  EXPECT_FALSE(fan.make.outlook().is_settled(fan.cdt, fan.make.goal()));
}

TEST(Outlook, TheTriangulationIsThatOfTheRegionAndGoesWithTheProof) {
  Seen fan(boundary_of({regular_polygon(20)}));
  EXPECT_EQ(fan.make.outlook().cdt().triangles.size(), 18U);
  const std::unique_ptr<RegionProof> proof = fan.make.outlook().take_proof();
  ASSERT_TRUE(proof);
  EXPECT_EQ(proof->cdt().triangles.size(), 18U);
}

}  // namespace
}  // namespace cover
