#include "geom/foot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geom/predicates.hpp"

namespace cover {
namespace {

TEST(Foot, IsExactOnLinesThatAreParallelToAnAxis) {
  const Point p{0.1 + 0.2, 1e-12};
  EXPECT_EQ(exact_foot({0, 0}, {1, 0}, p), (Point{p.x, 0}));
  EXPECT_EQ(exact_foot({3, -1}, {3, 1}, p), (Point{3, p.y}));
}

TEST(Foot, IsRoundedOnOthers) {
  EXPECT_FALSE(exact_foot({0, 0}, {1, 3}, {1, 0}).has_value());
  for (const Point end : {Point{0, 0}, Point{1, 3}}) {
    const Point other{1 - end.x, 3 - end.y};
    const Point foot = foot_on(end, other, {1, 0});
    EXPECT_NEAR(foot.x, 0.1, 1e-15);
    EXPECT_NEAR(foot.y, 0.3, 1e-15);
  }
}

TEST(Foot, TellsWhereOnALineOrSegmentItLies) {
  const Point a{1, 1}, b{5, 1};
  EXPECT_EQ(part_on_line(a, b, {2, 7}), 0.25);
  EXPECT_EQ(part_on_line(a, b, {-3, 0}), -1);
  EXPECT_EQ(nearest_on_line(a, b, {9, 0}), (Point{9, 1}));
  EXPECT_EQ(part_on_segment(a, b, {2, 7}), 0.25);
  EXPECT_EQ(part_on_segment(a, b, {-3, 0}), 0);
  EXPECT_EQ(part_on_segment(a, b, {9, 0}), 1);
  EXPECT_EQ(nearest_on_segment(a, b, {9, 4}), b);
  EXPECT_EQ(distance_to_segment({9, 4}, a, b), 5);
  EXPECT_EQ(distance_to_line({9, 4}, a, b), 3);
  EXPECT_EQ(part_on_segment(a, a, {9, 0}), 0);
  EXPECT_EQ(distance_to_segment({4, 5}, a, a), 5);
}

/// The square of the segment's length is no double; the foot was none either.
TEST(Foot, IsFoundOnASegmentOfUnitsInTheLastPlaceOfZero) {
  const double unit = 0x1p-1074;
  const Point a{-8 * unit, -8 * unit}, b{8 * unit, 8 * unit};
  EXPECT_EQ(foot_on(a, b, {-3 * unit, 3 * unit}), (Point{0, 0}));
  for (const Point far : {Point{8, -8}, Point{8, -7.99}, Point{1e300, -1e300}}) {
    const Point foot = foot_on(a, b, far);
    EXPECT_TRUE(a <= foot && foot <= b) << far.x;
  }
  EXPECT_EQ(foot_on({0, 0}, {1e-200, 1e-200}, {1e-200, 0}), (Point{5e-201, 5e-201}));
}

/// However thin the layer, a vertex encroaches no piece beside its foot.
TEST(Foot, LeavesTheVertexInNoDiametralDisk) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.1, 1), exponent(-15, -6);
  int exact = 0;
  for (int k = 0; k < 2000; ++k) {
    const Point a{-unit(random), 0.7}, b{1 + unit(random), 0.7};
    const Point p{unit(random), 0.7 + std::pow(10, exponent(random))};
    if (!(p.y > 0.7)) continue;
    const Point foot = foot_on(a, b, p);
    EXPECT_EQ(foot, foot_on(b, a, p));
    EXPECT_NE(compare_with_90_degrees(a, p, foot), Sign::positive) << k;
    EXPECT_NE(compare_with_90_degrees(foot, p, b), Sign::positive) << k;
    exact += foot.x == p.x ? 1 : 0;
  }
  EXPECT_GT(exact, 200);
}

}  // namespace
}  // namespace cover
