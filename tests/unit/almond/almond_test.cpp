#include "almond/almond.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "almond_of.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using testing::almond_of;

TEST(Almond, PointsOfTheArcSeeTheSideUnderItsAngle) {
  // Rounded coordinates, of size 4, turn the spokes from the ends by some 1e-15 over their length.
  for (const double nu : {std::numbers::pi / 3, 0.5, 1e-3, 1e-9}) {
    const Almond a = almond_of({1, 2}, {4, -1}, nu);
    for (const double s : {0.001, 0.2, 0.5, 0.9}) {
      const double rounding = 1e-15 / (nu * std::min(s, 1 - s));
      const Point x = a.at_place(s);
      EXPECT_NEAR(nu_at(a.from, x, a.to) / nu, 1, rounding) << nu << " " << s;
      EXPECT_NEAR(a.place_of_ratio(a.ratio_of(x)), s, 1e-12);
      // The angles at the ends are shares of nu.
      EXPECT_NEAR(angle_at(x, a.from, a.to) / nu, 1 - s, rounding);
      EXPECT_NEAR(angle_at(x, a.to, a.from) / nu, s, rounding);
      EXPECT_NEAR(a.power(x), 0, 1e-14);
      EXPECT_TRUE(a.on_the_arc(x));
    }
  }
}

TEST(Almond, PlaceIsZeroAndOneAtTheEnds) {
  const Almond a = almond_of({0, 0}, {1, 0}, 1);
  EXPECT_EQ(a.place_of_ratio(0), 0);
  EXPECT_EQ(a.place_of_ratio(kInfinity), 1);
  EXPECT_DOUBLE_EQ(a.place_of_ratio(1), 0.5);
}

TEST(Almond, PowerTellsInsideFromOutside) {
  const Almond a = almond_of({-1, 0}, {1, 0}, std::numbers::pi / 3);
  EXPECT_NEAR(a.height(), std::tan(std::numbers::pi / 6), 1e-15);
  EXPECT_LT(a.power({0, 0.99 * a.height()}), 0);
  EXPECT_GT(a.power({0, 1.01 * a.height()}), 0);
  const Vector up{0, 1};
  EXPECT_NEAR(a.power_slope({0, 0.5}, up),
              (a.power({0, 0.5 + 1e-6}) - a.power({0, 0.5 - 1e-6})) / 2e-6, 1e-9);
}

TEST(Almond, OfAHullSideIsTheSide) {
  Almond a = almond_of({0, 0}, {4, 0}, 0);
  a.kind = AlmondKind::hull_side;
  EXPECT_EQ(a.at_place(0.25), (Point{1, 0}));
  EXPECT_GT(a.power({1, 1}), 0);
  EXPECT_LT(a.power({1, -1}), 0);
}

TEST(MakeAlmonds, CapsAt120Degrees) {
  // The lower side is seen under more than 120 degrees, the others under less.
  const auto boundary = testing::boundary_of({{{-1, 0}, {1, 0}, {0, 0.1}}});
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const AngleLimit limit = angle_limit(cdt, boundary.sides, boundary.segments);
  const auto almonds = make_almonds(cdt, boundary.sides, boundary.segments, limit, {});
  for (const Almond& a : almonds) {
    const bool lower = a.from.y == 0 && a.to.y == 0;
    EXPECT_EQ(a.passes_apex(), lower);
    EXPECT_DOUBLE_EQ(a.nu, lower ? 2 * std::atan(0.1) : std::numbers::pi / 3);
  }
}

}  // namespace
}  // namespace cover
