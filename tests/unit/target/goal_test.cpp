#include "target/goal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cover {
namespace {

Point at_angle(double degrees, double radius = 1) {
  const double t = degrees * std::numbers::pi / 180;
  return {radius * std::cos(t), radius * std::sin(t)};
}

/// A triangle with the apex angle given, isosceles.
double excess_of_isosceles(const Goal& goal, double apex) {
  return excess(goal, {0, 0}, {1, 0}, at_angle(apex));
}

TEST(Goal, IsMetExactlyUpToTheAngles) {
  const Goal goal = Goal::of(Angle::degrees(100), Angle::degrees(20));
  EXPECT_NEAR(excess_of_isosceles(goal, 100), 0, 1e-12);
  EXPECT_LT(excess_of_isosceles(goal, 99), 0);
  EXPECT_GT(excess_of_isosceles(goal, 101), 0);
  EXPECT_NEAR(excess_of_isosceles(goal, 20), 0, 1e-12);
  EXPECT_GT(excess_of_isosceles(goal, 19), 0);
  EXPECT_LT(excess_of_isosceles(goal, 60), -0.3);
}

TEST(Goal, IgnoresSmallAnglesWithoutATarget) {
  const Goal goal = Goal::of(Angle::degrees(100), Angle::degrees(0));
  EXPECT_LE(excess_of_isosceles(goal, 1e-3), 0);
  EXPECT_GT(excess_of_isosceles(goal, 101), 0);
}

TEST(Goal, GrowsWithTheViolation) {
  const Goal goal = Goal::of(Angle::degrees(100), Angle::degrees(20));
  double before = 0;
  for (double apex = 105; apex < 180; apex += 5) {
    EXPECT_GT(excess_of_isosceles(goal, apex), before);
    before = excess_of_isosceles(goal, apex);
  }
  before = 0;
  for (double apex = 19; apex > 0; apex -= 1) {
    EXPECT_GT(excess_of_isosceles(goal, apex), before);
    before = excess_of_isosceles(goal, apex);
  }
}

TEST(Goal, IsTheSameFromEveryCornerAndAtEveryScale) {
  const Goal goal = Goal::of(Angle::degrees(100), Angle::degrees(20));
  const Point a{0.3, 0.1}, b{1.7, 0.4}, c{0.9, 2.2};
  const double value = excess(goal, a, b, c);
  EXPECT_NEAR(excess(goal, b, c, a), value, 1e-12);
  EXPECT_NEAR(excess(goal, c, a, b), value, 1e-12);
  const double s = 0x1p-30;
  EXPECT_EQ(excess(goal, {s * a.x, s * a.y}, {s * b.x, s * b.y}, {s * c.x, s * c.y}), value);
  EXPECT_EQ(excess(goal, a, c, b), kInverted);
}

TEST(Goal, AllowsWhatASideForces) {
  const Goal goal = Goal::of(Angle::degrees(100), Angle::degrees(20));
  const Point u{1, 0}, v = at_angle(140), w{0, 0};
  const double forced = 1 / std::tan(40 * std::numbers::pi / 180) - goal.large;
  const Allowance side{forced, 0};
  const SideAllowances opposite_to_w{&side, nullptr, nullptr};
  const SideAllowances elsewhere{nullptr, &side, nullptr};
  EXPECT_NEAR(excess(goal, w, u, v, opposite_to_w), 0, 1e-12);
  EXPECT_GT(excess(goal, w, u, v, elsewhere), 0.5);
}

TEST(Goal, DoesNotCountACornerOfTheInput) {
  const Goal goal = Goal::of(Angle::degrees(100), Angle::degrees(20));
  const Allowance none;
  const SideAllowances two_sides{nullptr, &none, &none};  // meeting at corner 0
  const SideAllowances one_side{nullptr, &none, nullptr};
  EXPECT_LT(excess(goal, {0, 0}, {1, 0}, at_angle(5), two_sides), 0);
  EXPECT_GT(excess(goal, {0, 0}, {1, 0}, at_angle(5), one_side), 0);
}

}  // namespace
}  // namespace cover
