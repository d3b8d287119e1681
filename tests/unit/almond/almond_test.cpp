#include "almond/almond.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "almond/arc_meeting.hpp"
#include "support/shapes.hpp"
#include "target/local_frame.hpp"

namespace cover {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Almond almond_of(Point from, Point to, double nu) {
  Almond a;
  a.u = 0, a.v = 1;
  a.from = from, a.to = to;
  a.length = length(a.chord());
  a.set_nu(nu);
  return a;
}

TEST(Almond, PointsOfTheArcSeeTheSideUnderItsAngle) {
  // Rounded coordinates, of size 4, turn the spokes from the ends by some 1e-15 over their length.
  for (const double nu : {kPi / 3, 0.5, 1e-3, 1e-9}) {
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
  const Almond a = almond_of({-1, 0}, {1, 0}, kPi / 3);
  EXPECT_NEAR(a.height(), std::tan(kPi / 6), 1e-15);
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
    EXPECT_DOUBLE_EQ(a.nu, lower ? 2 * std::atan(0.1) : kPi / 3);
  }
}

TEST(Meet, TwoArcsThatCrossTwice) {
  const Almond a = almond_of({0, 0}, {1, 0}, kPi / 3), b = almond_of({1, 0.4}, {0, 0.4}, kPi / 3);
  const std::vector<KnownVertex> known_a{{0, 0}, {1, kInfinity}}, known_b{{2, 0}, {3, kInfinity}};
  const Meetings m = meet(a, known_a, b, known_b);
  ASSERT_EQ(m.count, 2);
  for (const Meeting& x : m.item) {
    EXPECT_NEAR(x.at.y, 0.2, 1e-15);
    EXPECT_NEAR(x.place_a + x.place_b, 1, 1e-14);
    EXPECT_NEAR(a.power(x.at), 0, 1e-15);
    EXPECT_NEAR(b.power(x.at), 0, 1e-15);
  }
  EXPECT_NEAR(m.item[0].at.x + m.item[1].at.x, 1, 1e-14);
}

TEST(Meet, TouchingArcsHaveOnePoint) {
  const double height = almond_of({0, 0}, {1, 0}, kPi / 3).height();
  const Almond a = almond_of({0, 0}, {1, 0}, kPi / 3);
  const Almond b = almond_of({1, 2 * height}, {0, 2 * height}, kPi / 3);
  const std::vector<KnownVertex> known_a{{0, 0}, {1, kInfinity}}, known_b{{2, 0}, {3, kInfinity}};
  const Meetings m = meet(a, known_a, b, known_b);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.item[0].at.x, 0.5, 1e-6);
}

TEST(Meet, ACommonEndGivesTheOtherPointWithoutASquareRoot) {
  // A right corner: the arcs cross once more on its bisector; seen from either side.
  const Almond a = almond_of({0, 0}, {1, 0}, kPi / 3);
  Almond b = almond_of({0, 1}, {0, 0}, kPi / 3);
  b.u = 2, b.v = 0;
  const std::vector<KnownVertex> known_a{{0, 0}, {1, kInfinity}}, known_b{{2, 0}, {0, kInfinity}};
  for (const Meetings& m : {meet(a, known_a, b, known_b), meet(b, known_b, a, known_a)}) {
    ASSERT_EQ(m.count, 1);
    EXPECT_NEAR(m.item[0].at.x, m.item[0].at.y, 1e-15);
    EXPECT_GT(m.item[0].at.x, 0.1);
  }
}

TEST(Meet, ArcsTangentAtACommonEndDoNotMeet) {
  // A corner of 120 degrees.
  const Point far{std::cos(2 * kPi / 3), std::sin(2 * kPi / 3)};
  const Almond a = almond_of({0, 0}, {1, 0}, kPi / 3), b = almond_of(far, {0, 0}, kPi / 3);
  const std::vector<KnownVertex> known_a{{0, 0}, {1, kInfinity}}, known_b{{2, 0}, {0, kInfinity}};
  EXPECT_EQ(meet(a, known_a, b, known_b).count, 0);
}

TEST(LocalFrame, ShiftsOnlyWhereThatIsExact) {
  const std::vector<Point> exact{{1e6, 1e6}, {1e6 + 1, 1e6}, {1e6, 1e6 + 0.5}};
  const LocalFrame shifted(exact);
  EXPECT_TRUE(shifted.is_shifted());
  EXPECT_EQ(shifted.points()[1], (Point{1, 0}));
  EXPECT_EQ(shifted.restore(shifted.points()[2]), exact[2]);
  const std::vector<Point> inexact{{1, 0}, {1e-20, 0}, {0, 1}};
  const LocalFrame same(inexact);
  EXPECT_FALSE(same.is_shifted());
  EXPECT_EQ(same.points(), inexact);
}

}  // namespace
}  // namespace cover
