#include "geom/curves/touch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kReach = 1e-14;

TEST(TouchOf, CirclesTouchFromOutside) {
  const auto touch = touch_of({{0, 0}, 2}, {{3, 4}, 3}, kReach);
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->gap, 0);
  EXPECT_NEAR(touch->at.x, 1.2, 1e-15);
  EXPECT_NEAR(touch->at.y, 1.6, 1e-15);
  EXPECT_DOUBLE_EQ(touch->curvature, 1.0 / 2 + 1.0 / 3);
}

TEST(TouchOf, OneCircleTouchesAnotherFromInside) {
  for (const bool is_swapped : {false, true}) {
    const ArcCircle small{{3, 4}, 1}, large{{0, 0}, 6};
    const auto touch = is_swapped ? touch_of(large, small, kReach) : touch_of(small, large, kReach);
    ASSERT_TRUE(touch);
    EXPECT_EQ(touch->gap, 0);
    EXPECT_NEAR(touch->at.x, 3.6, 1e-15);
    EXPECT_NEAR(touch->at.y, 4.8, 1e-15);
    EXPECT_DOUBLE_EQ(touch->curvature, 1 - 1.0 / 6);
  }
}

/// Where plain differences of lengths would leave nothing but noise.
TEST(TouchOf, GapsAreExact) {
  const double bit = 0x1p-52;
  for (const double gap : {bit, -bit, 3 * bit}) {
    const auto outside = touch_of({{0, 0}, 1}, {{2 + gap, 0}, 1}, kReach);
    ASSERT_TRUE(outside || std::abs(gap) < 2 * bit) << gap;
    if (2 + gap != 2) {
      EXPECT_DOUBLE_EQ(outside->gap, (2 + gap) - 2);
    }
    const auto inside = touch_of({{0, 0}, 2}, {{1 - gap, 0}, 1}, kReach);
    ASSERT_TRUE(inside);
    EXPECT_DOUBLE_EQ(inside->gap, 1 - (1 - gap));
    const auto line = touch_of({{0, 1 + gap}, 1}, {-3, 0}, {5, 0}, kReach);
    ASSERT_TRUE(line);
    EXPECT_DOUBLE_EQ(line->gap, (1 + gap) - 1);
  }
}

TEST(TouchOf, ALineTouchesACircleAndThePlaceIsOnTheLine) {
  const auto flat = touch_of({{0.3, 0.7}, 0.7}, {-3, 0}, {3, 0}, kReach);
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->at, (Point{0.3, 0}));
  EXPECT_NEAR(flat->gap, 0, 1e-30);
  const auto slanted = touch_of({{0, 0}, 5}, {-1, 7}, {7, 1}, kReach);  // 3 x + 4 y = 25
  ASSERT_TRUE(slanted);
  EXPECT_NEAR(slanted->at.x, 3, 2e-15);
  EXPECT_NEAR(slanted->at.y, 4, 2e-15);
}

TEST(TouchOf, CirclesOfVeryDifferentRadiiTouch) {
  const auto touch = touch_of({{0, -1e9}, 1e9}, {{0, 1e-3}, 1e-3}, 1e-7);
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->at, (Point{0, 0}));
  EXPECT_EQ(touch->gap, 0);
  EXPECT_TRUE(touch_of({{0, -1e9}, 1e9}, {{0, 1e-3}, 1e-3}, 1e-30));
}

TEST(TouchOf, NearMissesAndCrossingsAreNone) {
  EXPECT_FALSE(touch_of({{0, 0}, 1}, {{2 + 1e-13, 0}, 1}, kReach));
  EXPECT_FALSE(touch_of({{0, 0}, 1}, {{2 - 1e-13, 0}, 1}, kReach));
  EXPECT_FALSE(touch_of({{0, 0}, 2}, {{1 - 1e-13, 0}, 1}, kReach));
  EXPECT_FALSE(touch_of({{0, 1 + 1e-13}, 1}, {-3, 0}, {5, 0}, kReach));
  EXPECT_FALSE(touch_of({{0, 0}, 1}, {{1, 0}, 1}, kReach));
  EXPECT_FALSE(touch_of({{0, 0}, 1}, {{10, 0}, 1}, kReach));
}

TEST(TouchOf, OneCircleTwiceAndCirclesWithOneCentreAreNone) {
  EXPECT_FALSE(touch_of({{1, 2}, 3}, {{1, 2}, 3}, kReach));
  EXPECT_FALSE(touch_of({{1, 2}, 3}, {{1, 2}, 3 + 1e-15}, kReach));
  EXPECT_FALSE(touch_of({{1, 2}, 3}, {{1, 2}, 2}, kReach));
}

TEST(TouchOf, NothingOverflowsOrVanishes) {
  for (const double unit : {0x1p-600, 0x1p600}) {
    const auto touch =
        touch_of({{0, 0}, 2 * unit}, {{3 * unit, 4 * unit}, 3 * unit}, kReach * unit);
    ASSERT_TRUE(touch) << unit;
    EXPECT_EQ(touch->gap, 0);
    EXPECT_FALSE(touch_of({{0, 0}, 2 * unit}, {{3 * unit, 4.001 * unit}, 3 * unit}, kReach * unit));
    EXPECT_TRUE(touch_of({{0, unit}, unit}, {-unit, 0}, {unit, 0}, kReach * unit));
    EXPECT_FALSE(touch_of({{0, 1.001 * unit}, unit}, {-unit, 0}, {unit, 0}, kReach * unit));
  }
}

}  // namespace
}  // namespace cover
