#include "quality/fault/fault.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cover {
namespace {

const Goal kGoal = Goal::of(Angle::degrees(100), Angle::degrees(20));

/// The triangle with these angles at (0, 0) and (1, 0), in degrees.
Corners with_angles(double at_a, double at_b) {
  const double a = at_a * std::numbers::pi / 180, b = at_b * std::numbers::pi / 180;
  const double side = std::sin(b) / std::sin(a + b);
  return {{0, 0}, {1, 0}, {side * std::cos(a), side * std::sin(a)}};
}

TEST(Fault, IsZeroWhereTargetsAreMet) {
  const Fault fault = fault_of(with_angles(60, 60), {}, kGoal);
  EXPECT_EQ(fault.worst(), 0);
}

TEST(Fault, GrowsInPartsOfWhatIsLeft) {
  EXPECT_NEAR(fault_of(with_angles(30, 140), {}, kGoal).wide, 0.5, 1e-12);
  EXPECT_NEAR(fault_of(with_angles(85, 85), {}, kGoal).narrow, 0.5, 1e-12);
  EXPECT_EQ(fault_of(with_angles(85, 85), {}, kGoal).wide, 0);
  EXPECT_NEAR(fault_of(with_angles(1e-3, 60), {}, kGoal).narrow, 1 - 5e-5, 1e-9);
}

TEST(Fault, CountsWhatASideForcesAsTheTarget) {
  const Allowance side{1 / std::tan(std::numbers::pi / 180 * 20) - kGoal.large, 0};  // 160 degrees
  const Fault fault = fault_of(with_angles(10, 5), {nullptr, nullptr, &side}, kGoal);
  EXPECT_NEAR(fault.wide, 0.25, 1e-9);  // 165 degrees
}

TEST(Fault, LeavesOutCornersBetweenTwoSides) {
  const Allowance none{};
  EXPECT_EQ(fault_of(with_angles(10, 85), {nullptr, &none, &none}, kGoal).narrow, 0);
  EXPECT_GT(fault_of(with_angles(10, 85), {nullptr, nullptr, &none}, kGoal).narrow, 0);
}

TEST(Fault, IsOneWhereATriangleHasNoArea) {
  EXPECT_EQ(fault_of(Corners({0, 0}, {1, 0}, {2, 0}), {}, kGoal).worst(), 1);
}

}  // namespace
}  // namespace cover
