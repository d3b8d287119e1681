#include "clean/remember_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <cover/cover_mesh.hpp>

#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"
#include "support/inputs/arc_devices.hpp"

namespace cover {
namespace {

std::size_t chords_of(const Pslg& pslg) {
  return static_cast<std::size_t>(
      std::count_if(pslg.segments.begin(), pslg.segments.end(),
                    [&](const Segment& s) { return circle_of(pslg, s) != nullptr; }));
}

/// A circle of radius 1 of so many chords, and a line through it at the height `y`.
Input circle_and_line(std::uint32_t chords, double half_length, double y) {
  Input input;
  testing::add_circle(input, {0, 0}, 1, static_cast<int>(chords));
  input.points.push_back({-half_length, y});
  input.points.push_back({half_length, y});
  InputSegment line;
  line.a = chords;
  line.b = chords + 1;
  line.id = chords;
  input.segments.push_back(line);
  return input;
}

void expect_two_cut(const Result<Prepared>& prepared, std::size_t chords) {
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(chords_of(prepared->pslg), chords - 2);
  EXPECT_TRUE(std::any_of(
      prepared->report.notes.begin(), prepared->report.notes.end(),
      [](const Note& note) { return note.message.starts_with("2 chords of arcs, the first at"); }));
}

TEST(RememberArcs, CleanInputsKeepAllChords) {
  Input input;
  testing::add_circle(input, {1, 2}, 3, 8);
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(chords_of(prepared->pslg), 8U);
  EXPECT_EQ(prepared->pslg.circles, input.circles);
}

/// Half a disc whose arc's ends are given once more as points, which rounding made others.
TEST(RememberArcs, EndsThatWereComputedTwiceAreOnTheirArc) {
  Input circle;
  testing::add_circle(circle, {3, 0.1}, 1, 12);
  Input input;
  input.circles = circle.circles;
  InputPolygon half;
  half.rings = {{circle.points.begin(), circle.points.begin() + 7}};
  half.circles = {{1, 1, 1, 1, 1, 1, 0, 0, 0}};
  const Point first = half.rings[0].front(), last = half.rings[0].back();
  half.rings[0].push_back({std::nextafter(last.x, -9), std::nextafter(last.y, -9)});
  half.rings[0].push_back({std::nextafter(first.x, -9), std::nextafter(first.y, -9)});
  half.material = "a";
  input.polygons = {half};
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->pslg.points.size(), 7U);
  EXPECT_EQ(chords_of(prepared->pslg), 6U);
}

/// A sector as other programs write it, with so many decimals that its ends miss each other.
TEST(RememberArcs, EndsThatWeldingMovedAreOnTheirArc) {
  Input circle;
  testing::add_circle(circle, {0, 0}, 45, 12);
  const auto rounded = [](Point p) {
    return Point{std::round(p.x * 1e6) / 1e6, std::round(p.y * 1e6) / 1e6};
  };
  Input input;
  input.circles = circle.circles;
  input.points = {circle.points[0], circle.points[1], circle.points[2]};
  for (const Point& p : {circle.points[2], Point{0, 0}, circle.points[0]})
    input.points.push_back(rounded(p) + Vector{1e-6, 1e-6});
  for (const std::uint32_t a : {0U, 1U, 3U, 4U}) {
    InputSegment s;
    s.a = a;
    s.b = a + 1;
    s.circle = a < 2 ? 1 : 0;
    s.id = a;
    input.segments.push_back(s);
  }
  Options options;
  options.weld = 1e-6;
  const Result<Prepared> prepared = prepare(input, options);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->pslg.points.size(), 4U);
  EXPECT_EQ(chords_of(prepared->pslg), 2U);
}

TEST(RememberArcs, ChordsThatLinesCutStayStraightAndAreTold) {
  expect_two_cut(prepare(circle_and_line(8, 2, 0.1)), 8);
}

/// Welding by more than a chord is long moves no end so far: pieces are no chords.
TEST(RememberArcs, PiecesOfFineChordsStayStraightHoweverMuchIsWelded) {
  Options options;
  options.weld = 3e-3;
  expect_two_cut(prepare(circle_and_line(360, 5, 0.0123), options), 360);
}

TEST(RememberArcs, PaintedRingsAndLinesRemember) {
  Input circle;
  testing::add_circle(circle, {0, 0}, 1, 12);
  Input input;
  input.circles = circle.circles;
  InputPolygon below;
  below.rings = {{{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}};
  below.material = "a";
  input.polygons = {below, testing::disc_of(circle, "b")};
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(chords_of(prepared->pslg), 12U);
}

/// A quarter of a disc and what is around it, whose circles differ by one unit in the last place:
/// welding makes the chords of both the same.
TEST(RememberArcs, CircleDrawnTwiceWithRoundingIsOne) {
  constexpr int kChords = 35;
  Input input;
  input.circles = {{{0, 0}, 1}, {{2e-16, 0}, 1}};
  InputPolygon quarter, around;
  const auto add = [&](InputPolygon& polygon, double shift, int from, int step,
                       std::uint32_t circle) {
    for (int k = from; k >= 0 && k <= kChords; k += step) {
      const double angle = Angle::degrees(90.0 * k / kChords).in_radians();
      polygon.rings[0].push_back({shift + std::cos(angle), std::sin(angle)});
      polygon.circles[0].push_back(k + step < 0 || k + step > kChords ? 0 : circle);
    }
  };
  quarter.rings = {{{0, 0}}};
  quarter.circles = {{0}};
  add(quarter, 0, 0, 5, 1);
  around.rings = {{{2, 0}, {2, 2}, {0, 2}}};
  around.circles = {{0, 0, 0}};
  add(around, 2e-16, kChords, -7, 2);
  quarter.material = "a";
  around.material = "b";
  input.polygons = {quarter, around};
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(chords_of(prepared->pslg), 11U);
  for (const Note& note : prepared->report.notes)
    EXPECT_EQ(note.message.find("of arcs"), std::string::npos) << note.message;
}

TEST(RememberArcs, EndsOffTheirCircleAreRefusedWithPlaces) {
  Input input;
  testing::add_circle(input, {0, 0}, 1, 8);
  input.points[3].x -= 0.01;
  const Result<Prepared> off = prepare(input);
  ASSERT_FALSE(off);
  EXPECT_EQ(off.error().code, ErrorCode::coordinate_out_of_range);
  EXPECT_NE(off.error().message.find("is off its circle about (0, 0)"), std::string::npos);
  ASSERT_FALSE(off.error().where.empty());
  EXPECT_EQ(off.error().where[0], input.points[3]);
  Input none;
  testing::add_circle(none, {0, 0}, 1, 8);
  none.segments[5].circle = 7;
  EXPECT_EQ(prepare(none).error().code, ErrorCode::id_out_of_range);
  none.segments[5].circle = 1;
  none.circles[0].radius = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(prepare(none).error().code, ErrorCode::coordinate_out_of_range);
}

}  // namespace
}  // namespace cover
