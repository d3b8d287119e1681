#include "cuts/periodic/periodic_sides.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <cover/cover_mesh.hpp>

#include "geom/curves/arc.hpp"

namespace cover {
namespace {

/// A quadrilateral with sides named bottom, right, top, left, from its lower left corner on;
/// `left` and `right` are points between the corners of these sides, from below.
Input cell(const std::array<Point, 4>& corners, const std::vector<Point>& left = {},
           const std::vector<Point>& right = {}) {
  Input input;
  input.points.assign(corners.begin(), corners.end());
  const auto add = [&](std::uint32_t a, std::uint32_t b, const char* name) {
    input.segments.push_back({a, b, 0, static_cast<long>(input.segments.size()), 0, name});
  };
  const auto chain = [&](std::uint32_t a, std::uint32_t b, const std::vector<Point>& between,
                         const char* name) {
    for (const Point& p : between) {
      input.points.push_back(p);
      add(a, static_cast<std::uint32_t>(input.points.size() - 1), name);
      a = static_cast<std::uint32_t>(input.points.size() - 1);
    }
    add(a, b, name);
  };
  add(0, 1, "bottom");
  chain(1, 2, right, "right");
  add(2, 3, "top");
  chain(0, 3, left, "left");
  return input;
}

const std::array<Point, 4> kSquare{Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}};

Options periodic(std::vector<PeriodicRule> rules) {
  Options options;
  options.periodic = std::move(rules);
  return options;
}

PeriodicRule translation(const char* from, const char* to) {
  return {from, to, PeriodicRule::Map::translation, {}, {}};
}

std::string refusal(const Input& input, const Options& options,
                    ErrorCode code = ErrorCode::bad_option) {
  const Result<Prepared> prepared = prepare(input, options);
  if (prepared) return "";
  EXPECT_EQ(prepared.error().code, code);
  return prepared.error().message;
}

TEST(PeriodicSides, PairsOfAUnitCell) {
  const Result<Prepared> prepared =
      prepare(cell(kSquare, {{0.125, 0.5}}, {{1.125, 0.5}}),
              periodic({translation("left", "right"), translation("top", "bottom")}));
  ASSERT_TRUE(prepared) << prepared.error().message;
  const Pslg& pslg = prepared->pslg;
  EXPECT_EQ(pslg.periodic.size(), 3U);
  EXPECT_TRUE(prepared->report.changes.empty());
  for (const SegmentPair& pair : pslg.periodic) {
    const Segment& from = pslg.segments[pair.from.index()];
    const Segment& to = pslg.segments[pair.to.index()];
    const Point a = pslg.points[from.a.index()],
                b = pslg.points[(pair.turned ? to.b : to.a).index()];
    if (pair.rule == 0) {
      EXPECT_EQ(b, (Point{a.x + 1, a.y}));
    } else {
      EXPECT_EQ(b, (Point{a.x, a.y - 1}));
    }
  }
}

TEST(PeriodicSides, RoundingIsTakenAwayAndNotTold) {
  // 0.1 + 0.2 is not 0.3.
  const Result<Prepared> prepared =
      prepare(cell({Point{0.1, 0}, Point{0.3, 0}, Point{0.3, 1}, Point{0.1, 1}}, {{0.1, 0.3}},
                   {{0.3, 0.1 + 0.2}}),
              periodic({translation("left", "right")}));
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_TRUE(prepared->report.changes.empty());
  const auto& points = prepared->pslg.points;
  EXPECT_EQ(points[4].y, points[5].y);
}

TEST(PeriodicSides, LargerMovesAreToldAndStrictRefusesThem) {
  const Input input = cell(kSquare, {{0, 0.5}}, {{1, 0.5 + 1e-11}});
  Options options = periodic({translation("left", "right")});
  const Result<Prepared> prepared = prepare(input, options);
  ASSERT_TRUE(prepared) << prepared.error().message;
  ASSERT_EQ(prepared->report.changes.size(), 1U);
  EXPECT_EQ(prepared->report.changes[0].kind, Change::Kind::welded);
  EXPECT_EQ(prepared->pslg.points[4].y, prepared->pslg.points[5].y);
  options.strict = true;
  EXPECT_NE(refusal(input, options, ErrorCode::changed_input).find("was moved by 1e-11"),
            std::string::npos);
}

TEST(PeriodicSides, PointsOfOneSideComeToTheOther) {
  const Input input = cell(kSquare, {{0, 0.25}, {0, 0.5}}, {{1, 0.75}});
  Options options = periodic({translation("left", "right")});
  const Result<Prepared> prepared = prepare(input, options);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->pslg.periodic.size(), 4U);
  EXPECT_EQ(prepared->report.changes.size(), 2U);  // a segment of each side
  options.strict = true;
  EXPECT_NE(refusal(input, options, ErrorCode::changed_input).find("was cut at"),
            std::string::npos);
}

/// A strip whose sides bend to the right, as arcs of two chords: corners, then the arcs' middles.
/// `left` and `right`, if given, are points between the lower ends and the middles.
Input bent_cell(std::optional<Point> left, std::optional<Point> right, bool is_right_straight) {
  Input input;
  const double bulge = std::numbers::sqrt2 - 1;
  input.points = {{0, 0}, {3, 0}, {3, 2}, {0, 2}, {bulge, 1}, {3 + bulge, 1}};
  input.circles = {{{-1, 1}, std::numbers::sqrt2}, {{2, 1}, std::numbers::sqrt2}};
  const auto add = [&](std::uint32_t a, std::uint32_t b, const char* name, std::uint32_t circle) {
    input.segments.push_back({a, b, 0, static_cast<long>(input.segments.size()), 0, name});
    input.segments.back().circle = circle;
  };
  const auto side = [&](std::array<std::uint32_t, 3> at, std::optional<Point> point,
                        const char* name, std::uint32_t circle) {
    if (point) {
      const auto added = static_cast<std::uint32_t>(input.points.size());
      input.points.push_back(*point);
      add(at[0], added, name, circle);
      add(added, at[1], name, circle);
    } else {
      add(at[0], at[1], name, circle);
    }
    add(at[1], at[2], name, circle);
  };
  add(0, 1, "bottom", 0);
  add(3, 2, "top", 0);
  side({0, 4, 3}, left, "left", 1);
  side({1, 5, 2}, right, "right", is_right_straight ? 0 : 2);
  return input;
}

/// A point of the left side's arc, at this angle as seen from its centre.
Point on_left_arc(double degrees) {
  const double u = degrees * std::numbers::pi / 180;
  return {-1 + std::numbers::sqrt2 * std::cos(u), 1 + std::numbers::sqrt2 * std::sin(u)};
}

TEST(PeriodicSides, PointsOfAnArcComeToTheOtherArc) {
  const Point at = on_left_arc(-15), image{at.x + 3, at.y};
  for (const bool is_left : {true, false}) {
    const Input input = is_left ? bent_cell(at, {}, false) : bent_cell({}, image, false);
    Options options = periodic({translation("left", "right")});
    const Result<Prepared> prepared = prepare(input, options);
    ASSERT_TRUE(prepared) << prepared.error().message;
    const Pslg& pslg = prepared->pslg;
    ASSERT_EQ(pslg.periodic.size(), 3U);
    EXPECT_EQ(prepared->report.changes.size(), 1U);
    for (const SegmentPair& pair : pslg.periodic) {
      const Segment& from = pslg.segments[pair.from.index()];
      const Segment& to = pslg.segments[pair.to.index()];
      EXPECT_EQ(from.circle, 1U);
      EXPECT_EQ(to.circle, 2U);
      const Point a = pslg.points[from.a.index()], b = pslg.points[to.a.index()];
      EXPECT_EQ(b, (Point{a.x + 3, a.y}));
    }
  }
}

TEST(PeriodicSides, PointsBesideAnArcComeToItsChordWhichIsStraightThen) {
  const Point middle{(std::numbers::sqrt2 - 1) / 2, 0.5};
  const Input input = bent_cell({}, Point{middle.x + 3, middle.y}, true);
  const Result<Prepared> prepared = prepare(input, periodic({translation("left", "right")}));
  ASSERT_TRUE(prepared) << prepared.error().message;
  const Pslg& pslg = prepared->pslg;
  ASSERT_EQ(pslg.periodic.size(), 3U);
  std::size_t straight = 0;
  for (const SegmentPair& pair : pslg.periodic) {
    const Segment& from = pslg.segments[pair.from.index()];
    const bool is_cut = std::min(pslg.points[from.a.index()].y, pslg.points[from.b.index()].y) < 1;
    EXPECT_EQ(circle_of(pslg, from) == nullptr, is_cut);
    if (is_cut) ++straight;
  }
  EXPECT_EQ(straight, 2U);
}

TEST(PeriodicSides, PointsBesideBothArcAndChordAreRefused) {
  const Point at = on_left_arc(-15);
  for (const double off : {-0.01, 0.01}) {
    const std::string message = refusal(bent_cell({}, Point{at.x + 3 + off, at.y}, true),
                                        periodic({translation("left", "right")}));
    EXPECT_NE(message.find("from 'left'"), std::string::npos) << message;
  }
}

TEST(PeriodicSides, APointGoesOnFromLineToLine) {
  // Three sides of a hexagon, each the image of the one before.
  Input input;
  for (int k = 0; k < 6; ++k) {
    const double u = std::numbers::pi * k / 3;
    input.points.push_back({std::cos(u), std::sin(u)});
  }
  input.points.push_back(
      {(input.points[0].x + input.points[1].x) / 2, (input.points[0].y + input.points[1].y) / 2});
  input.segments = {{0, 6, 0, 0, 0, "a"}, {6, 1, 0, 1, 0, "a"}, {1, 2, 0, 2, 0, "b"},
                    {2, 3, 0, 3, 0, "c"}, {3, 4, 0, 4, 0, ""},  {4, 5, 0, 5, 0, ""},
                    {5, 0, 0, 6, 0, ""}};
  const PeriodicRule first{"a", "b", PeriodicRule::Map::rotation, {0, 0}, Angle::degrees(60)};
  const PeriodicRule second{"b", "c", PeriodicRule::Map::rotation, {0, 0}, Angle::degrees(60)};
  const Result<Prepared> prepared = prepare(input, periodic({second, first}));
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->pslg.periodic.size(), 4U);
}

TEST(PeriodicSides, MirrorsFindTheirAxis) {
  const Input input =
      cell({Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}, {{-0.25, 0.3}}, {{1.25, 0.3}});
  const Result<Prepared> prepared =
      prepare(input, periodic({{"left", "right", PeriodicRule::Map::mirror, {}, {}}}));
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->pslg.periodic.size(), 2U);
  EXPECT_NE(refusal(input, periodic({translation("left", "right")})), "");
}

TEST(PeriodicSides, WhatDoesNotMatchIsRefusedWithPlaces) {
  const Input input = cell(kSquare, {{0.1, 0.5}}, {{1.2, 0.5}});
  const std::string message = refusal(input, periodic({translation("left", "right")}));
  EXPECT_NE(message.find("'left' and 'right': the lines do not match"), std::string::npos);
  EXPECT_NE(message.find("0.1"), std::string::npos) << message;
  // Seen from outside, both sides would have to turn round.
  const PeriodicRule wrong{
      "left", "right", PeriodicRule::Map::rotation, {0, 0}, Angle::degrees(30)};
  EXPECT_NE(refusal(input, periodic({wrong})), "");
}

/// An eighth of a ring, as other programs write it: with 6 decimals.
TEST(PeriodicSides, SidesThatDecimalsPutOffMatchWithinWelding) {
  Input input;
  input.points = {{8, 0},
                  {10, 0},
                  {21.5, 0},
                  {15.202796, 15.202796},
                  {7.071068, 7.071068},
                  {5.656854, 5.656854}};
  for (const char* name : {"start", "start", "outer", "end", "end", "inner"}) {
    const auto k = static_cast<std::uint32_t>(input.segments.size());
    input.segments.push_back({k, (k + 1) % 6, 0, static_cast<long>(k), 0, name});
  }
  PeriodicRule rule = translation("start", "end");
  rule.map = PeriodicRule::Map::rotation;
  rule.angle = Angle::degrees(45);
  Options options = periodic({rule});
  const std::string message = refusal(input, options);
  EXPECT_NE(message.find("which is 3.53e-07 from 'start'"), std::string::npos) << message;
  EXPECT_NE(message.find("; --weld 3e-08 moves points of one side"), std::string::npos) << message;
  options.weld = 3e-8;
  const Result<Prepared> prepared = prepare(input, options);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->pslg.periodic.size(), 2U);
  EXPECT_EQ(prepared->report.changes.size(), 3U);
  const std::vector<Point>& points = prepared->pslg.points;
  for (const std::size_t k : {0U, 1U, 2U})
    EXPECT_NEAR(points[5 - k].x, points[k].x * std::sqrt(0.5), 4e-15) << k;
  EXPECT_TRUE(cover_mesh(input, options));
}

TEST(PeriodicSides, UnknownNamesAndSelfImagesAreRefused) {
  const Input input = cell(kSquare);
  EXPECT_NE(refusal(input, periodic({translation("left", "rihgt")})).find("did you mean 'right'?"),
            std::string::npos);
  Input twice = input;  // by its marker, the right side is also a part of another line
  twice.segments[1].marker = 7;
  twice.segments[3].marker = 7;
  const PeriodicRule self{
      "7", "right", PeriodicRule::Map::rotation, {0.5, 0.5}, Angle::degrees(180)};
  EXPECT_NE(refusal(twice, periodic({self})).find("no line can be taken to itself"),
            std::string::npos);
  Options options = periodic({translation("left", "right")});
  options.method = Method::nonobtuse;
  EXPECT_NE(refusal(input, options).find("nonobtuse"), std::string::npos);
}

}  // namespace
}  // namespace cover
