#include "io/input/drawings/curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace cover {
namespace {

constexpr std::size_t kMany = 1 << 20;

std::vector<Point> cut(CurveCutter& cutter, const Arc& arc) { return *cutter.points(arc, kMany); }

TEST(PointOnCircle, IsExactOnTheAxesAndSymmetric) {
  EXPECT_EQ(point_on_circle({1, 2}, 3, 0), (Point{4, 2}));
  EXPECT_EQ(point_on_circle({1, 2}, 3, 90), (Point{1, 5}));
  EXPECT_EQ(point_on_circle({1, 2}, 3, 180), (Point{-2, 2}));
  EXPECT_EQ(point_on_circle({1, 2}, 3, -90), (Point{1, -1}));
  for (const double angle : {1.0, 22.5, 30.0, 44.5}) {
    const Point p = point_on_circle({}, 1, angle);
    EXPECT_NEAR(p.x, std::cos(angle * M_PI / 180), 1e-15);
    EXPECT_EQ(point_on_circle({}, 1, 90 - angle), (Point{p.y, p.x}));
    EXPECT_EQ(point_on_circle({}, 1, 180 - angle), (Point{-p.x, p.y}));
    EXPECT_EQ(point_on_circle({}, 1, 360 - angle), (Point{p.x, -p.y}));
    EXPECT_EQ(point_on_circle({}, 1, angle - 720), p);
  }
}

TEST(StepForChordError, KeepsTheSagitta) {
  for (const double error : {0.3, 1e-3, 1e-9}) {
    const double half = step_for_chord_error(1, error) / 2 * M_PI / 180;
    EXPECT_NEAR(2 * std::pow(std::sin(half / 2), 2), error, 1e-12 * error);
  }
  EXPECT_EQ(step_for_chord_error(1, 5), 120);
}

TEST(CurveCutter, CutsACircleEvenlyAndClosesIt) {
  CurveCutter cutter;
  const Arc circle{{0, 0}, 2, 0, 360, 360.0 / 64};
  cutter.add(circle);
  const std::vector<Point> points = cut(cutter, circle);
  ASSERT_EQ(points.size(), 65u);
  EXPECT_EQ(points.front(), (Point{2, 0}));
  EXPECT_EQ(points.back(), points.front());
  EXPECT_EQ(points[16], (Point{0, 2}));
  const double chord = std::hypot(points[1].x - points[0].x, points[1].y - points[0].y);
  for (std::size_t k = 1; k < points.size(); ++k)
    EXPECT_NEAR(std::hypot(points[k].x - points[k - 1].x, points[k].y - points[k - 1].y), chord,
                1e-14);
}

TEST(CurveCutter, GivesNeighboursTheSamePointsWhateverTheirExtent) {
  // A rotor's full circle and two teeth whose ends and fineness do not fit it.
  CurveCutter cutter;
  const Arc circle{{1, 1}, 0.7, 0, 360, 11};
  const Arc tooth{{1, 1}, 0.7, 13.3, 71.9, 4};
  const Arc backward{{1, 1}, 0.7, 430, 350, 30};
  for (const Arc& arc : {circle, tooth, backward}) cutter.add(arc);
  const std::vector<Point> around = cut(cutter, circle);
  const std::set<Point> all(around.begin(), around.end());
  for (const Arc& arc : {tooth, backward}) {
    const std::vector<Point> points = cut(cutter, arc);
    EXPECT_EQ(points.front(), point_on_circle(arc.centre, arc.radius, arc.from));
    EXPECT_EQ(points.back(), point_on_circle(arc.centre, arc.radius, arc.to));
    for (const Point p : points) EXPECT_TRUE(all.contains(p));
    // Nothing of the circle lies between two neighbours on the arc.
    for (std::size_t k = 1; k < points.size(); ++k) {
      const auto i = std::find(around.begin(), around.end() - 1, points[k - 1]) - around.begin();
      const auto j = std::find(around.begin(), around.end() - 1, points[k]) - around.begin();
      const auto n = static_cast<std::ptrdiff_t>(around.size()) - 1;
      EXPECT_EQ((arc.to > arc.from ? j - i + n : i - j + n) % n, 1);
    }
  }
}

TEST(CurveCutter, TellsOfNumbersOfChordsThatDoNotCount) {
  const Arc of_8{{1, 2}, 0.5, 0, 360, 45, 8}, of_12{{1, 2}, 0.5, 0, 360, 30, 12};
  const Arc third_of_12{{1, 2}, 0.5, 10, 130, 120.0 / 4, 4};
  const Arc other{{1, 2}, 0.7, 0, 360, 45, 8}, at_most{{1, 2}, 0.5, 0, 360, 50};
  using Sentences = std::vector<std::string>;
  const auto told = [](const std::vector<Arc>& arcs) {
    CurveCutter cutter;
    for (const Arc& arc : arcs) cutter.add(arc);
    for (const Arc& arc : arcs) cut(cutter, arc);
    return cutter.finer_than_asked();
  };
  EXPECT_TRUE(told({of_8, of_8, other, at_most}).empty());
  EXPECT_TRUE(told({of_12, third_of_12}).empty());
  EXPECT_EQ(told({of_12, of_8, other}),
            Sentences{"the circle around (1, 2) of radius 0.5 asks for 8 chords and gets 12: "
                      "curves on one circle share their points, so the shortest chords count for "
                      "all of them"});
  const Arc of_5{{0, 0}, 1, 0, 110, 110.0 / 5, 5}, of_6{{0, 0}, 1, 240, 110, 130.0 / 6, 6};
  EXPECT_EQ(told({of_5, of_6}),
            Sentences{"the arc around (0, 0) of radius 1 from 0 to 110 degrees asks for 5 chords "
                      "and gets 6: curves on one circle share their points, so the shortest chords "
                      "count for all of them"});
}

TEST(CurveCutter, ClosesAFullArcOnItsFirstPointWhereverThatIs) {
  for (int k = -3600; k < 3600; ++k) {
    const double from = k / 10.0, to = (k + 3600) / 10.0;
    for (const Arc& arc : {Arc{{0, 0}, 10, from, to, 15}, Arc{{0, 0}, 10, to, from, 15}}) {
      ASSERT_TRUE(arc.full()) << from;
      CurveCutter cutter;
      cutter.add(arc);
      const std::vector<Point> points = cut(cutter, arc);
      ASSERT_EQ(points.size(), 25U) << from;
      EXPECT_EQ(points.front(), points.back()) << from;
    }
  }
  EXPECT_FALSE((Arc{{0, 0}, 10, 1.3, 361.3 - 1e-12, 15}).full());
}

TEST(CurveCutter, GivesTheSameArcBackwardsFromItsOtherEnd) {
  CurveCutter cutter;
  const Arc there{{0, 0}, 1, 17, 113, 7}, back{{0, 0}, 1, 113, 17, 7};
  cutter.add(there);
  cutter.add(back);
  std::vector<Point> points = cut(cutter, there);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(points, cut(cutter, back));
}

TEST(CurveCutter, RefusesMorePointsThanAllowed) {
  CurveCutter cutter;
  const Arc fine{{0, 0}, 1, 0, 360, 1e-300};
  cutter.add(fine);
  EXPECT_FALSE(cutter.points(fine, kMany).has_value());
}

TEST(CutArcBetween, KeepsBothEndsAndDoesNotDependOnTheDirection) {
  const Point a{0.8660254037844387, 0.5}, b{-1, 1e-17};
  const std::vector<Point> ccw = *cut_arc_between(a, b, {0, 0}, false, 10, kMany);
  ASSERT_EQ(ccw.size(), 16u);
  EXPECT_EQ(ccw.front(), a);
  EXPECT_EQ(ccw.back(), b);
  for (const Point p : ccw) {
    EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-15);
    EXPECT_GT(p.y, 0);
  }
  std::vector<Point> back = *cut_arc_between(b, a, {0, 0}, true, 10, kMany);
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(back, ccw);
  EXPECT_EQ(cut_arc_between(a, b, {0, 0}, true, 10, kMany)->size(), 22u);
  EXPECT_EQ(cut_arc_between(a, a, {0, 0}, false, 10, kMany)->size(), 37u);
  EXPECT_EQ(cut_arc_between(a, a, {0, 0}, true, 10, kMany)->size(), 37u);
}

}  // namespace
}  // namespace cover
