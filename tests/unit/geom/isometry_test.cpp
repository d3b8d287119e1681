#include "geom/isometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

TEST(Isometry, QuarterTurnsAndHalvesAreExact) {
  const Point p{0.1, -0.7};
  EXPECT_EQ(image_of(rotation_about({0, 0}, Angle::degrees(90)), p), (Point{0.7, 0.1}));
  EXPECT_EQ(image_of(rotation_about({0, 0}, Angle::degrees(-90)), p), (Point{-0.7, -0.1}));
  EXPECT_EQ(image_of(rotation_about({0, 0}, Angle::degrees(180)), p), (Point{-0.1, 0.7}));
  EXPECT_EQ(image_of(rotation_about({1, 2}, Angle::degrees(270)), Point({2, 2})), (Point{1, 1}));
  EXPECT_EQ(image_of(rotation_about({0, 0}, Angle::degrees(60)), Point({2, 0})),
            (Point{1, std::sqrt(3.0)}));
}

TEST(Isometry, ARotationIsRoundedOnce) {
  const std::uint64_t seed = testing::test_seed(71);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int k = 0; k < 1000; ++k) {
    const double degrees = 180 * uniform(random);
    const Point p{uniform(random), uniform(random)};
    const Isometry map = rotation_about({0, 0}, Angle::degrees(degrees));
    // The same with the digits of a long double.
    const long double t = static_cast<long double>(Angle::degrees(degrees).in_radians());
    const long double x = std::cos(t) * p.x - std::sin(t) * p.y,
                      y = std::sin(t) * p.x + std::cos(t) * p.y;
    const Point q = image_of(map, p);
    EXPECT_NEAR(q.x, static_cast<double>(x), 0x1p-51);
    EXPECT_NEAR(q.y, static_cast<double>(y), 0x1p-51);
    const Point back = image_of(inverse_of(map), q);
    EXPECT_NEAR(back.x, p.x, 0x1p-51);
    EXPECT_NEAR(back.y, p.y, 0x1p-51);
  }
}

TEST(Isometry, MirrorsAlongAxesAndDiagonalsAreExact) {
  const Isometry across = reflection_between({0.25, 0.3}, {0.75, 0.3});
  EXPECT_EQ(image_of(across, Point({0, 0.1})), (Point{1, 0.1}));
  const Isometry diagonal = reflection_between({0, 1}, {1, 0});
  EXPECT_EQ(image_of(diagonal, Point({0.1, 0.7})), (Point{0.7, 0.1}));
  const Isometry back = inverse_of(diagonal);
  EXPECT_EQ(image_of(back, Point({0.7, 0.1})), (Point{0.1, 0.7}));
}

TEST(Isometry, AMirrorKeepsDistancesAndItsOwnInverse) {
  const Isometry map = reflection_between({0.3, 0.9}, {1.7, -0.4});
  const Point p{5, -3}, q = image_of(map, p), back = image_of(map, q);
  EXPECT_NEAR(back.x, p.x, 1e-14);
  EXPECT_NEAR(back.y, p.y, 1e-14);
  const Point end = image_of(map, Point({0.3, 0.9}));
  EXPECT_NEAR(end.x, 1.7, 1e-15);
  EXPECT_NEAR(end.y, -0.4, 1e-15);
}

}  // namespace
}  // namespace cover
