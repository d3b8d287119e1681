#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/option_ranges.hpp>
#include <cover/verify.hpp>

#include "disks/fill_disks.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

Options nonobtuse() {
  Options options;
  options.method = Method::nonobtuse;
  options.threads = 1;
  return options;
}

/// Meshes, and checks the result against the input as it was before segments were cut.
Output expect_nonobtuse(const Input& input, const Options& options = nonobtuse()) {
  Result<Prepared> before = prepare(input, options);
  EXPECT_TRUE(before.has_value());
  Result<Output> output = cover_mesh(input, options);
  EXPECT_TRUE(output.has_value()) << output.error().message;
  VerifyOptions verify;
  verify.allow_split = true;
  const TriangleSoup soup = triangle_soup(output->mesh);
  for (const Violation& v : verify_cover(before->pslg, before->table, soup, verify).violations) {
    ADD_FAILURE() << v.message;
  }
  // Against the PSLG with cut segments every segment is one edge.
  for (const Violation& v : verify_cover(output->pslg, output->table, soup).violations) {
    ADD_FAILURE() << v.message;
  }
  EXPECT_GE(output->report.quality.largest_nu.in_degrees(), 180 - kLargestSnapped);
  return *std::move(output);
}

Input with_segment(Input input, Point a, Point b) {
  const auto n = static_cast<std::uint32_t>(input.points.size());
  input.points.push_back(a);
  input.points.push_back(b);
  InputSegment segment;
  segment.a = n;
  segment.b = n + 1;
  segment.marker = 7;
  input.segments.push_back(segment);
  return input;
}

const testing::Loop kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(Nonobtuse, RefusesDisksThatCoordinatesCannotHold) {
  // A point 1e-16 from a segment, among coordinates of 8.
  Input input = testing::segments_between({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {5, 6}, {1e-16, 3}},
                                          {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}});
  const Result<Output> refused = cover_mesh(input, nonobtuse());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::meshing_incomplete);
  EXPECT_NE(refused.error().message.find("rounded coordinates cannot hold"), std::string::npos)
      << refused.error().message;
  EXPECT_EQ(refused.error().where, std::vector<Point>({{0, 8}, {0, 0}}));
}

TEST(Nonobtuse, RefusesPointsThatLieOnASegmentUpToRounding) {
  // No segment ends in the last point.
  for (const double x : {1e-16, 1e-320}) {
    const Input input =
        testing::segments_between({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {16, 0}, {16, 8}, {x, 3}},
                                  {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {1, 4}, {4, 5}, {5, 2}});
    const Result<Output> output = cover_mesh(input, nonobtuse());
    ASSERT_FALSE(output);
    EXPECT_EQ(output.error().code, ErrorCode::meshing_incomplete);
    EXPECT_EQ(output.error().where, (std::vector<Point>{{0, 8}, {0, 0}}));
  }
}

TEST(Nonobtuse, OneRegionIsPackedForItself) {
  const Output output = expect_nonobtuse(testing::input_of(kSquare));
  EXPECT_LE(output.mesh.tri().n_vertices(), 41U);
  EXPECT_EQ(output.report.regions[0].method, "nonobtuse");
}

TEST(Nonobtuse, RegionsShareTheirInterfaces) {
  expect_nonobtuse(testing::checker(4, 3, 1));
  expect_nonobtuse(testing::transformed(testing::checker(3, 2, 2), 0x1p-30, {0, 0}));
}

TEST(Nonobtuse, SlitsAreSplitAlikeFromBothSides) {
  const Output output = expect_nonobtuse(with_segment(testing::input_of(kSquare), {1, 1}, {2, 3}));
  double length = 0;
  for (const auto e : output.mesh.tri().edges()) {
    if (output.mesh.marker(e) == 7) length += output.mesh.tri().calc_edge_length(e);
  }
  EXPECT_NEAR(length, std::sqrt(5.0), 1e-12);
}

TEST(Nonobtuse, InterfacesKeepTheirLength) {
  const Input input = testing::checker(3, 2, 3);
  const Output output = expect_nonobtuse(input);
  const Result<Prepared> before = prepare(input, nonobtuse());
  std::map<std::uint32_t, double> found;
  for (const auto e : output.mesh.tri().edges()) {
    found[output.mesh.interface(e).value()] += output.mesh.tri().calc_edge_length(e);
  }
  for (const Interface& line : before->table.interfaces) {
    EXPECT_NEAR(found[line.id.value()], line.length, 1e-12) << line.name;
  }
}

TEST(Nonobtuse, TheSameForAnyNumberOfThreads) {
  const Input input = testing::checker(4, 2, 4);
  Options two = nonobtuse();
  two.threads = 2;
  const TriangleSoup a = triangle_soup(cover_mesh(input, nonobtuse())->mesh);
  const TriangleSoup b = triangle_soup(cover_mesh(input, two)->mesh);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

/// Points some units in the last place from segments: the packing's vertices have no room.
TEST(Nonobtuse, AlmondsHoldTheBoundWhereRoundingBreaksThePacking) {
  const Input input =
      testing::segments_between({{15.000000000000002, 1.0000000000000018},
                                 {1.0000000000000013, 1.0000000000000004},
                                 {1.0000000000000004, 14.000000000000009},
                                 {4.0000000000000036, 1},
                                 {2, 1.0000000000000018},
                                 {5, 1.0000000000000004}},
                                {{1, 0}, {3, 5}, {0, 3}, {3, 1}, {2, 3}, {1, 2}, {5, 1}, {5, 0}});
  const Result<Output> output = cover_mesh(input, nonobtuse());
  ASSERT_TRUE(output) << output.error().message;
  const RegionReport& thin = output->report.regions[0];
  EXPECT_TRUE(thin.bound_held);
  EXPECT_EQ(thin.method, "almond");
  ASSERT_EQ(thin.notes.size(), 1U);
  EXPECT_EQ(thin.notes[0].kind, Note::Kind::target_missed);
  EXPECT_NE(thin.notes[0].message.find("; the almond method, which holds the bound, made"),
            std::string::npos)
      << thin.notes[0].message;
  for (const Violation& v :
       verify_cover(output->pslg, output->table, triangle_soup(output->mesh)).violations)
    ADD_FAILURE() << v.message;
}

TEST(Nonobtuse, RefusesWhatItCannotDo) {
  Options hull = nonobtuse();
  hull.hull = true;
  const Result<Output> refused = cover_mesh(testing::input_of(kSquare), hull);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::bad_option);

  // Two slits 1e-7 apart: ten million disks on each.
  Input close = with_segment(testing::input_of(kSquare), {1, 1}, {3, 1});
  close = with_segment(close, {1, 1 + 1e-7}, {3, 1 + 1e-7});
  const Result<Output> crowded = cover_mesh(close, nonobtuse());
  ASSERT_FALSE(crowded.has_value());
  EXPECT_EQ(crowded.error().code, ErrorCode::meshing_incomplete);
  EXPECT_EQ(crowded.error().where.size(), 2U);
}

}  // namespace
}  // namespace cover
