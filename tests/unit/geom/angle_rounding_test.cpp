// What is obtuse: by its own corners alone, and by no more than rounding them can make.
#include "geom/angle_rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cover {
namespace {

TEST(Bluntness, OfRightAnglesIsNo) {
  EXPECT_EQ(bluntness({1, 0}, {0, 0}, {0, 1}), Blunt::no);
  EXPECT_EQ(bluntness({1e9 + 1, 7}, {1e9, 7}, {1e9, 7.5}), Blunt::no);
  EXPECT_EQ(bluntness({1, 1e-300}, {0, 0}, {0, 1}), Blunt::no);
}

/// Near the origin coordinates hold what they do not hold far away.
TEST(Bluntness, DependsOnTheTrianglesOwnCoordinates) {
  const double lean = 0x1p-40;
  EXPECT_EQ(bluntness({1, 0}, {0, 0}, {-lean, 1}), Blunt::yes);
  const double far = 0x1p+20;  // doubles are 2^-32 apart
  EXPECT_EQ(bluntness({far + 1, 0}, {far, 0}, {far - 0x1p-32, 1}), Blunt::by_rounding);
  EXPECT_EQ(bluntness({far + 1, 0}, {far, 0}, {far - 0x1p-29, 1}), Blunt::yes);
}

TEST(Bluntness, IsFoundAtAnyCorner) {
  const Point a{0, 0}, b{1, 0}, c{-0.5, 1};
  EXPECT_EQ(bluntness_of(a, b, c), Blunt::yes);
  EXPECT_EQ(bluntness_of(b, c, a), Blunt::yes);
  EXPECT_EQ(bluntness_of(c, a, b), Blunt::yes);
  EXPECT_EQ(bluntness_of({0, 0}, {1, 0}, {0.5, 1}), Blunt::no);
}

/// A right angle whose corners are rounded is never called obtuse, wherever it lies.
TEST(Bluntness, RoundingMakesNothingObtuse) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1), exponent(-3, 7);
  int above = 0;
  for (int k = 0; k < 20000; ++k) {
    const double far = std::pow(10, exponent(random)), size = std::pow(10, exponent(random) - 4);
    const long double x = far * unit(random), y = far * unit(random);
    const long double u = size * unit(random), v = size * unit(random), part = unit(random);
    const auto at = [&](long double dx, long double dy) {
      return Point{static_cast<double>(x + dx), static_cast<double>(y + dy)};
    };
    const Point apex = at(0, 0), p = at(u, v), q = at(-part * v, part * u);
    if (apex == p || apex == q || orientation(p, apex, q) == Sign::zero) continue;
    const Blunt blunt = bluntness(p, apex, q);
    EXPECT_NE(blunt, Blunt::yes) << k;
    EXPECT_EQ(blunt, bluntness(q, apex, p));
    EXPECT_EQ(blunt != Blunt::no, compare_with_90_degrees(p, apex, q) == Sign::positive);
    above += blunt == Blunt::by_rounding ? 1 : 0;
  }
  EXPECT_GT(above, 5000);
}

}  // namespace
}  // namespace cover
