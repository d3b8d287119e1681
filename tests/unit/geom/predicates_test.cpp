#include "geom/predicates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

TEST(Orientation, FindsTheSignOneUlpOffALine) {
  const Point a{0.5, 0.5}, b{12, 12};
  EXPECT_EQ(orientation(a, b, {24, 24}), Sign::zero);
  EXPECT_EQ(orientation(a, b, {24, std::nextafter(24.0, 25.0)}), Sign::positive);
  EXPECT_EQ(orientation(a, b, {24, std::nextafter(24.0, 23.0)}), Sign::negative);
}

TEST(Orientation, WorksWhereProductsUnderflow) {
  const double s = 0x1p-600;
  EXPECT_EQ(orientation({0, 0}, {s, 0}, {0, s}), Sign::positive);
  EXPECT_EQ(orientation({0, 0}, {s, s}, {2 * s, 2 * s}), Sign::zero);
}

TEST(InCircle, FindsCocircularPoints) {
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {1, 1}, {0, 1}), Sign::zero);
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {1, 1}, {0, std::nextafter(1.0, 0.0)}), Sign::positive);
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {1, 1}, {0, std::nextafter(1.0, 2.0)}), Sign::negative);
}

TEST(CompareWith120Degrees, AgreesWithAtan2AwayFromTheBoundary) {
  const std::uint64_t seed = testing::test_seed(1);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int above = 0;
  for (int k = 0; k < 20000; ++k) {
    const Point a{uniform(random), uniform(random)}, p{uniform(random), uniform(random)},
        b{uniform(random), uniform(random)};
    const double ux = a.x - p.x, uy = a.y - p.y, vx = b.x - p.x, vy = b.y - p.y;
    const double angle = std::atan2(std::abs(ux * vy - uy * vx), ux * vx + uy * vy);
    if (std::abs(angle - 2 * M_PI / 3) < 1e-9) continue;
    const Sign expected = angle > 2 * M_PI / 3 ? Sign::positive : Sign::negative;
    above += expected == Sign::positive;
    ASSERT_EQ(compare_with_120_degrees(a, p, b), expected);
    ASSERT_EQ(compare_with_120_degrees(b, p, a), expected);
  }
  EXPECT_GT(above, 1000);
}

TEST(CompareWith120Degrees, DecidesWhatDoublesCannot) {
  // sqrt(3) is irrational: with rational coordinates the angle is never exactly 120 degrees
  // between an axis and another direction, however close it comes.
  const double h = std::sqrt(3.0) / 2;
  const Sign at = compare_with_120_degrees({1, 0}, {0, 0}, {-0.5, h});
  EXPECT_NE(at, Sign::zero);
  EXPECT_NE(at, compare_with_120_degrees(
                    {1, 0}, {0, 0}, {-0.5, std::nextafter(h, at == Sign::positive ? 1.0 : 0.0)}));
  EXPECT_EQ(compare_with_120_degrees({1, 0}, {0, 0}, {-1, 0}), Sign::positive);
  EXPECT_EQ(compare_with_120_degrees({1, 0}, {0, 0}, {1, 1}), Sign::negative);
}

TEST(CompareWith90Degrees, IsExact) {
  EXPECT_EQ(compare_with_90_degrees({1, 0}, {0, 0}, {0, 1}), Sign::zero);
  EXPECT_EQ(compare_with_90_degrees({1, 0}, {0, 0}, {-0x1p-60, 1}), Sign::positive);
  EXPECT_EQ(compare_with_90_degrees({1, 0}, {0, 0}, {0x1p-60, 1}), Sign::negative);
}

}  // namespace
}  // namespace cover
