#include "geom/curves/arc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geom/vector.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

Point on_unit(double turn) { return {std::cos(turn), std::sin(turn)}; }

TEST(ArcOver, PointsLieOnTheCircleEitherWayRound) {
  const ArcCircle circle{{0, 0}, 1};
  for (const auto& [from, to] : {std::pair(0.3, 1.1), std::pair(1.1, 0.3), std::pair(-2.0, -0.1)}) {
    const ArcOver arc(circle, on_unit(from), on_unit(to));
    for (const double share : {0.125, 0.5, 0.9}) {
      const Point p = arc.at(share), expected = on_unit(from + share * (to - from));
      EXPECT_NEAR(p.x, expected.x, 1e-15);
      EXPECT_NEAR(p.y, expected.y, 1e-15);
      EXPECT_NEAR(arc.share_of(p), share, 1e-14);
      EXPECT_TRUE(arc.is_on_circle(p));
    }
    EXPECT_EQ(arc.at(0), on_unit(from));
    EXPECT_EQ(arc.at(1), on_unit(to));
    EXPECT_LT(arc.share_of(on_unit(from - 0.1 * (to - from))), 0);
    EXPECT_GT(arc.share_of(on_unit(to + 0.1 * (to - from))), 1);
    EXPECT_FALSE(arc.is_on_circle({0.999999, 0}));
  }
}

TEST(ArcOver, ALargeCircleLosesNoDigits) {
  const ArcCircle circle{{0, -1e9}, 1e9};
  const ArcOver arc(circle, {-1, -5e-10}, {1, -5e-10});
  EXPECT_NEAR(arc.middle().y, 0, 1e-18);
  EXPECT_NEAR(arc.middle().x, 0, 1e-15);
  for (const double y : {1e-10, 3e-7}) {
    EXPECT_NEAR(arc.distance_from_circle({0, y}), y, 1e-15);
    EXPECT_NEAR(arc.distance_from_circle({0.5, y}), y + 1.25e-10, 1e-15);
    EXPECT_NEAR(arc.share_of({0.5, y}), 0.75, 1e-14);
  }
}

TEST(CommonPoints, AreWhereCirclesCrossOrTouch) {
  const ArcCircle circle{{0, 0}, 1};
  const std::vector<Point> crossing = common_points(circle, {{1, 0}, 1});
  ASSERT_EQ(crossing.size(), 2U);
  for (const Point p : crossing) {
    EXPECT_NEAR(p.x, 0.5, 1e-15);
    EXPECT_NEAR(std::abs(p.y), std::sqrt(0.75), 1e-15);
  }
  for (const ArcCircle& touching : {ArcCircle{{-0.3, 0}, 0.7}, ArcCircle{{-1.1, 0}, 0.1}}) {
    const std::vector<Point> points = common_points(circle, touching);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_NEAR(points[0].x, -1, 1e-6);
    EXPECT_NEAR(points[1].y, 0, 1e-6);
  }
  for (const ArcCircle& apart : {ArcCircle{{0, 0}, 1}, ArcCircle{{0, 0}, 0.999},
                                 ArcCircle{{1e-3, 0}, 0.99}, ArcCircle{{5, 5}, 1}})
    EXPECT_TRUE(common_points(circle, apart).empty());
}

TEST(ArcOver, CutsOffWhatLiesBetweenItAndItsChord) {
  for (const bool is_turned : {false, true}) {
    const Point a = on_unit(0.3), b = on_unit(1.1);
    const ArcOver arc({{0, 0}, 1}, is_turned ? b : a, is_turned ? a : b);
    EXPECT_TRUE(arc.cuts_off({0.99 * std::cos(0.7), 0.99 * std::sin(0.7)}));
    EXPECT_FALSE(arc.cuts_off({1.01 * std::cos(0.7), 1.01 * std::sin(0.7)}));
    EXPECT_FALSE(arc.cuts_off({0.9 * std::cos(0.7), 0.9 * std::sin(0.7)}));
    EXPECT_FALSE(arc.cuts_off({0.99 * std::cos(1.3), 0.99 * std::sin(1.3)}));
  }
}

/// The Jacobian at a place, from the shape functions and in long double: another way than the one
/// that is tested.
long double jacobian_at(const CurvedTriangle& t, long double r, long double s) {
  const long double q = 1 - r - s;
  const long double dr[6] = {1 - 4 * q, 4 * r - 1, 0, 4 * (q - r), 4 * s, -4 * s};
  const long double ds[6] = {1 - 4 * q, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (q - s)};
  long double xr = 0, yr = 0, xs = 0, ys = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    xr += dr[k] * t[k].x, yr += dr[k] * t[k].y;
    xs += ds[k] * t[k].x, ys += ds[k] * t[k].y;
  }
  return xr * ys - xs * yr;
}

CurvedTriangle straight(Point a, Point b, Point c) {
  return {a, b, c, midpoint(a, b), midpoint(b, c), midpoint(c, a)};
}

TEST(HasPositiveJacobian, HoldsForStraightTrianglesHoweverFlat) {
  EXPECT_TRUE(has_positive_jacobian(straight({0, 0}, {1, 0}, {0.5, 0x1p-60})));
  EXPECT_FALSE(has_positive_jacobian(straight({0, 0}, {1, 0}, {0.5, 0})));
  EXPECT_FALSE(has_positive_jacobian(straight({0, 0}, {1, 0}, {0.5, -1e-3})));
  // Nor does it matter how small or large they are.
  EXPECT_TRUE(has_positive_jacobian(straight({0, 0}, {1, 0}, {0.5, 0x1p-1000})));
  EXPECT_TRUE(has_positive_jacobian(straight({0, 0}, {0x1p-800, 0}, {0, 0x1p-800})));
  EXPECT_TRUE(has_positive_jacobian(straight({0, 0}, {0x1p900, 0}, {0, 0x1p900})));
  EXPECT_FALSE(has_positive_jacobian(straight({0, 0}, {0x1p-800, 0}, {0, -0x1p-800})));
  EXPECT_FALSE(has_positive_jacobian(straight({0, 0}, {INFINITY, 0}, {0, 1})));
  // A power of two has exact middles anywhere.
  EXPECT_TRUE(
      has_positive_jacobian(straight({1024, 1024}, {1025, 1024}, {1024.5, 1024 + 0x1p-30})));
}

TEST(HasPositiveJacobian, IsNeverWrongOnRandomTriangles) {
  const std::uint64_t seed = testing::test_seed(72);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int proven = 0, inverted = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    CurvedTriangle t =
        straight({uniform(random), uniform(random)}, {uniform(random), uniform(random)},
                 {uniform(random), uniform(random)});
    const double bend = 0.3 * std::abs(uniform(random));
    for (std::size_t k = 3; k < 6; ++k)
      t[k] = t[k] + bend * Vector{uniform(random), uniform(random)};
    long double least = 1;
    constexpr int kSteps = 12;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j)
        least = std::min(least, jacobian_at(t, static_cast<long double>(i) / kSteps,
                                            static_cast<long double>(j) / kSteps));
    }
    const bool is_proven = has_positive_jacobian(t);
    proven += is_proven ? 1 : 0;
    inverted += least <= 0 ? 1 : 0;
    EXPECT_TRUE(!is_proven || least > 0);
  }
  EXPECT_GT(proven, 2000);
  EXPECT_GT(inverted, 2000);
}

TEST(AreaBesideChord, IsThatOfAParabola) {
  // y = 1 - x^2 above the x axis has the area 4/3; the region on the left of its chord, run from
  // right to left, loses it, and gains it the other way round.
  EXPECT_DOUBLE_EQ(area_beside_chord({1, 0}, {-1, 0}, {0, 1}), 4.0 / 3);
  EXPECT_DOUBLE_EQ(area_beside_chord({-1, 0}, {1, 0}, {0, 1}), -4.0 / 3);
}

}  // namespace
}  // namespace cover
