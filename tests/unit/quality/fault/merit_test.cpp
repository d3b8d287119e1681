// Which of two triangulations is better, and which triangles miss the goal.
#include "quality/fault/merit.hpp"

#include <cmath>
#include <numbers>

#include "../coupled_meshes.hpp"
#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

double minus_cot(double degrees) { return -1 / std::tan(degrees * std::numbers::pi / 180); }

TEST(Merit, OfASquareIsThatOfItsTwoTriangles) {
  const RegionBoundary square = boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const MutableMesh mesh = cdt_mesh(square);
  const Merit merit = merit_of(mesh, default_goal());
  EXPECT_TRUE(merit.complete);
  EXPECT_EQ(merit.above, 0u);
  EXPECT_EQ(merit.triangles, 2u);
  EXPECT_DOUBLE_EQ(merit.large, default_goal().large) << "no lower than the goal";
  EXPECT_DOUBLE_EQ(merit.small, default_goal().small);
}

TEST(Merit, TellsAnglesThatTheInputForcesFromThoseThatItDoesNot) {
  // One triangle of 120 degrees: there is no other, so it is forced.
  const double h = std::sqrt(3) / 6;
  const RegionBoundary flat = boundary_of({{{0, 0}, {1, 0}, {0.5, h}}});
  const MutableMesh forced = cdt_mesh(flat);
  EXPECT_FALSE(is_above(forced, 0, default_goal()));
  const Merit merit = merit_of(forced, default_goal());
  EXPECT_EQ(merit.above, 0u);
  EXPECT_TRUE(merit.complete);
  EXPECT_NEAR(merit.large, minus_cot(120), 1e-12);

  // A regular 20-gon can have 100 degrees, but not without a new vertex.
  const MutableMesh fan = cdt_mesh(boundary_of({regular_polygon(20, 1, {0, 0})}));
  const Merit missed = merit_of(fan, default_goal());
  EXPECT_GT(missed.above, 0u);
  EXPECT_FALSE(missed.complete);
  std::size_t above = 0;
  for (std::uint32_t t = 0; t < fan.triangles.size(); ++t) {
    above += is_above(fan, t, default_goal()) ? 1 : 0;
  }
  EXPECT_EQ(missed.above, above);
  EXPECT_GT(missed.large, default_goal().large);
}

TEST(Merit, OrdersByLargestThenFarAboveThenAboveThenSmallestThenTriangles) {
  const Merit base{0, 2, 5, 3, 3, 100, false};
  EXPECT_FALSE(is_better_by_largest(base, base));
  EXPECT_TRUE(is_better_by_largest({0, 1.9, 9, 9, 9, 999, false}, base));
  EXPECT_TRUE(is_better_by_largest({0, 2, 9, 2, 9, 999, false}, base));
  EXPECT_TRUE(is_better_by_largest({0, 2, 4, 3, 9, 999, false}, base));
  EXPECT_TRUE(is_better_by_largest({0, 2, 5, 3, 2.9, 999, false}, base));
  EXPECT_TRUE(is_better_by_largest({0, 2, 5, 3, 3, 99, false}, base));
  EXPECT_FALSE(is_better_by_largest({0, 2 - 1e-13, 6, 3, 3, 100, false}, base));
}

TEST(Merit, CountsDecideBetweenLargestAnglesThatAreAlike) {
  // 126 and 124 degrees; 126 and 134; just above the target.
  const Merit three{0, 0.6745, 5, 3, 3, 100, false}, one{0, 0.7265, 5, 1, 3, 100, false};
  EXPECT_TRUE(is_better_by_largest(one, three));
  EXPECT_FALSE(is_better_by_largest(three, one));
  EXPECT_TRUE(is_better_by_largest(three, {0, 0.9657, 5, 1, 3, 100, false}));
  // Near 180 degrees what remains counts: 0.187 and 0.186 degrees, against 0.2.
  EXPECT_TRUE(
      is_better_by_largest({0, 306, 90, 30, 9, 100, false}, {0, 305, 90, 80, 9, 100, false}));
  EXPECT_FALSE(
      is_better_by_largest({0, 306, 90, 30, 9, 100, false}, {0, 286, 90, 80, 9, 100, false}));
  // The target itself is like nothing else: 126 degrees, forced, against 128.
  const Merit met{0.7265, 0.7265, 5, 3, 3, 100, false};
  EXPECT_TRUE(is_better_by_largest(met, {0.7265, 0.7813, 5, 1, 3, 100, false}));
  EXPECT_FALSE(is_better_by_largest({0.7265, 0.7813, 5, 1, 3, 100, false}, met));
  const Merit many{0, 0.01, 8, 0, 3, 100, false}, few{0, 0.04, 1, 0, 3, 100, false};
  EXPECT_TRUE(is_better_by_largest(few, many));
  EXPECT_FALSE(is_better_by_largest(many, few));
  EXPECT_TRUE(is_better_by_largest(many, {0, 0.06, 1, 0, 3, 100, false}));
  EXPECT_TRUE(is_better_by_largest({0, 0, 0, 0, 9, 100, true}, few));
}

TEST(Merit, IsTheSameWhetherOrNotTheGoalIsSet) {
  // The notch of the second one forces an angle above both goals.
  for (const RegionBoundary& boundary :
       {flower(60), boundary_of({{{0, 0}, {10, 0}, {10, 5}, {6, 0.5}, {3, 1.5}, {0, 5}}})}) {
    MutableMesh mesh = cdt_mesh(boundary);
    const Merit set = merit_of(mesh, default_goal());
    mesh.set_goal(Goal::of(Angle::degrees(130), Angle::degrees(10)));
    const Merit other = merit_of(mesh, default_goal());
    EXPECT_EQ(set.large, other.large);
    EXPECT_EQ(set.above, other.above);
    EXPECT_EQ(set.far_above, other.far_above);
    EXPECT_EQ(set.small, other.small);
    EXPECT_EQ(set.complete, other.complete);
  }
}

Merit with_fault(double wide, double narrow, std::size_t far_above, double large = 1) {
  Merit merit;
  merit.large = large;
  merit.fault = {wide, narrow};
  merit.far_above = far_above;
  return merit;
}

TEST(Order, BalancesWideAndNarrow) {
  const Order order{Prefer::balanced, 0.72, 10};
  EXPECT_TRUE(order.is_better(with_fault(0.1, 0.2, 0), with_fault(0.05, 0.3, 0)));
  EXPECT_FALSE(order.is_better(with_fault(0.05, 0.3, 0), with_fault(0.1, 0.2, 0)));
  EXPECT_TRUE(order.is_better(with_fault(0.1, 0.6, 0), with_fault(0.3, 0.2, 1)));   // 120 degrees
  EXPECT_FALSE(order.is_better(with_fault(0.1, 0.8, 0), with_fault(0.3, 0.2, 1)));  // degenerate
  EXPECT_TRUE(order.is_better(with_fault(0.1, 0.8, 0), with_fault(0.9, 0.2, 1)));
  EXPECT_TRUE(order.is_better(with_fault(0, 0.9, 0, 9), with_fault(0, 0.1, 0, 11)));  // the bound
}

TEST(Merit, WhatIsWithinTheBoundIsBetterWhateverIsPreferred) {
  const Merit within{0, 2, 9, 9, 3, 100, false}, beyond{0, 2.01, 1, 1, 3, 100, false};
  ASSERT_TRUE(is_better_by_largest(beyond, within)) << "alike, so that the counts decide";
  for (const Prefer prefer : {Prefer::largest, Prefer::balanced}) {
    const Order order{prefer, 0.72, 2.005};
    EXPECT_TRUE(order.is_better(within, beyond));
    EXPECT_FALSE(order.is_better(beyond, within));
  }
}

TEST(Merit, OfTwoMeshesTheOneWithFewerNegativeOnesIsBetterWithinTheBound) {
  Order order;
  order.prefer = Prefer::balanced;
  order.bound = 1.7;
  Merit good, bad;
  good.negative = 1;
  bad.large = 1.5;
  bad.far_above = 9;
  bad.fault = {0.5, 0.9};
  EXPECT_TRUE(order.is_better(bad, good));
  EXPECT_FALSE(order.is_better(good, bad));
  bad.large = 1.8;
  EXPECT_TRUE(order.is_better(good, bad));
  order.prefer = Prefer::largest;
  bad.large = 1.5;
  EXPECT_TRUE(order.is_better(bad, good));
}

}  // namespace
}  // namespace cover
