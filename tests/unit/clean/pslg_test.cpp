#include "clean/pslg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/run_all.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

/// Points numbered from 1 on lines 2, 3, ... of in.poly; segments numbered from 1 after them.
Input poly(std::vector<Point> points, const std::vector<std::pair<int, int>>& segments) {
  Input input;
  input.source = "in.poly";
  input.points = std::move(points);
  int line = 2;
  for (std::size_t k = 0; k < input.points.size(); ++k) {
    input.point_ids.push_back(static_cast<long>(k + 1));
    input.point_lines.push_back(line++);
  }
  for (const auto& [a, b] : segments) {
    InputSegment s;
    s.a = static_cast<std::uint32_t>(a - 1);
    s.b = static_cast<std::uint32_t>(b - 1);
    s.id = static_cast<long>(input.segments.size() + 1);
    s.line = ++line;
    input.segments.push_back(s);
  }
  return input;
}

/// What a strict run says.
Error refusal(const Input& input) {
  Report report;
  Options strict;
  strict.strict = true;
  const auto pslg = make_pslg(input, strict, report);
  return pslg ? Error{ErrorCode::internal, "accepted", {}, {}} : pslg.error();
}

TEST(MakePslg, KeepsACleanInput) {
  Input input = poly({{0, 0}, {1, 0}, {0, 1}}, {{1, 2}, {2, 3}, {3, 1}});
  input.segments[1].name = "gate";
  input.segments[2].marker = 7;
  input.point_markers = {1, 2, 3};
  Report report;
  const auto pslg = make_pslg(input, {}, report);
  ASSERT_TRUE(pslg) << pslg.error().message;
  EXPECT_EQ(pslg->points, input.points);
  EXPECT_EQ(pslg->point_ids, input.point_ids);
  EXPECT_EQ(pslg->point_markers, input.point_markers);
  ASSERT_EQ(pslg->segments.size(), 3U);
  EXPECT_EQ(pslg->names, (std::vector<std::string>{"", "gate"}));
  EXPECT_EQ(pslg->segments[1].name, 1U);
  EXPECT_EQ(pslg->segments[2].marker, 7);
  EXPECT_EQ(pslg->segments[2].id, 3);
  EXPECT_TRUE(report.notes.empty());
}

TEST(MakePslgStrict, ListsAllDuplicatePoints) {
  const Error e = refusal(poly({{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 0}}, {{1, 2}}));
  EXPECT_EQ(e.code, ErrorCode::duplicate_point);
  EXPECT_EQ(e.message,
            "in.poly: point 3 at (0, 0) (line 4) has the coordinates of point 1; "
            "point 5 at (1, 0) (line 6) has the coordinates of point 2");
  EXPECT_EQ(e.where, (std::vector<Point>{{0, 0}, {1, 0}}));
  ASSERT_EQ(e.inputs.size(), 4U);
  EXPECT_EQ(e.inputs[3].id, 5);
}

/// A ring of more segments than one thread takes for itself: clean, with one of them twice, and
/// with one that is no segment.
TEST(MakePslg, IsTheSameForAnyNumberOfThreads) {
  constexpr int kPoints = 70'000;
  std::vector<Point> points;
  std::vector<std::pair<int, int>> ring;
  for (int k = 0; k < kPoints; ++k) {
    const double turn = 2 * 3.14159265358979 * k / kPoints;
    points.push_back({std::cos(turn), std::sin(turn)});
    ring.emplace_back(k + 1, (k + 1) % kPoints + 1);
  }
  std::vector<std::pair<int, int>> twice = ring, at_point = ring;
  twice.emplace_back(41, 40);
  at_point.emplace_back(7, 7);
  for (const auto& segments : {ring, twice, at_point}) {
    Input input = poly(points, segments);
    input.segments[12].name = input.segments[60'000].name = "gate";
    for (const unsigned workers : {1U, 2U, 3U, 7U}) {
      with_team(workers, [&](const Team& team) {
        Report report;
        std::optional<Triangulation> whole;
        const auto pslg = make_pslg(input, {}, report, &whole, team);
        ASSERT_TRUE(pslg);
        EXPECT_EQ(pslg->points, points);
        EXPECT_EQ(pslg->point_ids, input.point_ids);
        EXPECT_EQ(pslg->segments.size(), ring.size());
        EXPECT_EQ(whole.has_value(), segments == ring);
        EXPECT_EQ(report.changes.empty(), segments == ring);
        const auto named =
            std::count_if(pslg->segments.begin(), pslg->segments.end(),
                          [&](const Segment& s) { return pslg->names[s.name] == "gate"; });
        EXPECT_EQ(named, 2);
      });
    }
  }
}

TEST(MakePslg, CountsWhatItDoesNotList) {
  EXPECT_NE(refusal(poly(std::vector<Point>(9), {{1, 2}})).message.find("; and 3 more like these"),
            std::string::npos);
}

TEST(MakePslgStrict, RefusesZeroLength) {
  const Error e = refusal(poly({{0, 0}, {1, 0}}, {{1, 2}, {2, 2}}));
  EXPECT_EQ(e.code, ErrorCode::zero_length_segment);
  EXPECT_EQ(e.message,
            "in.poly: segment 2 from point 2 to point 2 (line 6) at (1, 0) has length zero");
}

TEST(MakePslgStrict, RefusesDuplicateSegments) {
  const Error e = refusal(poly({{0, 0}, {1, 0}, {0, 1}}, {{1, 2}, {2, 3}, {2, 1}}));
  EXPECT_EQ(e.code, ErrorCode::duplicate_segment);
  EXPECT_EQ(
      e.message,
      "in.poly: segment 3 from point 2 to point 1 (line 8), between (0, 0) and (1, 0), is the "
      "same as segment 1");
}

TEST(MakePslgStrict, RefusesCrossings) {
  const Error e = refusal(poly({{0, 0}, {2, 2}, {0, 2}, {2, 0}}, {{1, 2}, {3, 4}}));
  EXPECT_EQ(e.code, ErrorCode::crossing_segments);
  EXPECT_EQ(e.message,
            "in.poly: segment 1 from point 1 to point 2 (line 7) crosses segment 2 from point 3 to "
            "point 4 (line 8) near (1, 1)");
  EXPECT_EQ(e.where, (std::vector<Point>{{1, 1}}));
}

TEST(MakePslgStrict, ListsAllCrossingsOverlapsAndTouches) {
  // Two crossings, three lines through (10, 1), an overlap, and a T-junction.
  const Error e = refusal(
      poly({{0, 0},
            {4, 0},
            {1, -1},
            {1, 1},
            {2, -1},
            {2, 1},
            {9, 0},
            {11, 2},
            {9, 2},
            {11, 0},
            {10, 0},
            {10, 2},
            {0, 5},
            {3, 5},
            {1, 5},
            {4, 5},
            {2, 4},
            {2, 5}},
           {{1, 2}, {3, 4}, {5, 6}, {7, 8}, {9, 10}, {11, 12}, {13, 14}, {15, 16}, {17, 18}}));
  EXPECT_EQ(e.code, ErrorCode::crossing_segments);
  EXPECT_EQ(e.where, (std::vector<Point>{{1, 0}, {2, 0}, {10, 1}, {1, 5}, {2, 5}}));
  EXPECT_NE(
      e.message.find(
          "crosses segment 5 from point 9 to point 10 (line 25) and 1 more segment near (10, 1)"),
      std::string::npos)
      << e.message;
  EXPECT_NE(e.message.find("overlap from (1, 5) on"), std::string::npos) << e.message;
  EXPECT_NE(e.message.find("point 18 at (2, 5) (line 19) lies inside segment 7"), std::string::npos)
      << e.message;
}

TEST(MakePslgStrict, CountsCrossingsThatItDoesNotList) {
  std::vector<Point> points{{0, 0}, {100, 0}};
  std::vector<std::pair<int, int>> segments{{1, 2}};
  for (int k = 1; k < 100; ++k) {
    points.push_back({double(k), -1});
    points.push_back({double(k), 1});
    segments.emplace_back(2 * k + 1, 2 * k + 2);
  }
  const Error e = refusal(poly(points, segments));
  EXPECT_EQ(e.where.size(), 99U);
  EXPECT_NE(e.message.find("; and 94 more like these"), std::string::npos) << e.message;
}

TEST(MakePslgStrict, RefusesALonePointOnASegment) {
  const Error e = refusal(poly({{0, 0}, {2, 0}, {1, 0}}, {{1, 2}}));
  EXPECT_EQ(e.code, ErrorCode::point_on_segment);
  EXPECT_NE(e.message.find("point 3 at (1, 0) (line 4) lies inside segment 1"), std::string::npos);
}

TEST(MakePslgStrict, RefusesTJunctions) {
  const Error e = refusal(poly({{0, 0}, {2, 0}, {1, 0}, {1, 2}}, {{1, 2}, {3, 4}}));
  EXPECT_EQ(e.code, ErrorCode::point_on_segment);
  EXPECT_EQ(e.message,
            "in.poly: point 3 at (1, 0) (line 4) lies inside segment 1 from point 1 to point 2 "
            "(line 7)");
}

TEST(MakePslgStrict, RefusesOverlaps) {
  const Error e = refusal(poly({{0, 0}, {2, 0}, {1, 0}, {3, 0}, {0, 1}}, {{1, 2}, {3, 4}, {1, 5}}));
  EXPECT_EQ(e.code, ErrorCode::overlapping_segments);
  EXPECT_NE(e.message.find("overlap from (1, 0) on"), std::string::npos) << e.message;
  EXPECT_EQ(e.inputs.size(), 2U);
}

TEST(MakePslg, RefusesWhatIsNotFinite) {
  Input input = poly({{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}}, {{1, 2}});
  EXPECT_EQ(refusal(input).code, ErrorCode::non_finite_coordinate);
  EXPECT_EQ(refusal(input).message, "in.poly: point 2 at (1, nan) (line 3) is not finite");
  input.points[1] = {1, 1};
  input.seeds.emplace_back();
  input.seeds[0].at.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(input).code, ErrorCode::non_finite_coordinate);
}

TEST(MakePslg, RefusesIndicesOutOfRange) {
  const Error e = refusal(poly({{0, 0}, {1, 0}}, {{1, 5}}));
  EXPECT_EQ(e.code, ErrorCode::id_out_of_range);
  EXPECT_EQ(
      e.message,
      "in.poly: segment 1 (line 5) ends at the point with the index 4, but there are 2 points");
}

TEST(MakePslg, RefusesAnInputWithoutSegments) {
  EXPECT_EQ(refusal(poly({{0, 0}, {1, 0}, {0, 1}}, {})).code, ErrorCode::no_segments);
  EXPECT_EQ(refusal({}).code, ErrorCode::no_segments);
  EXPECT_EQ(refusal(poly({{0, 0}, {1, 0}, {0, 1}}, {})).message,
            "in.poly: there are no segments and no polygons; --hull meshes the points");
  EXPECT_EQ(refusal(poly({{0, 0}, {1, 0}}, {})).message,
            "in.poly: there are no segments and no polygons");
}

}  // namespace
}  // namespace cover
