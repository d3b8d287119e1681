#include "cuts/cut_segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include <cover/cover_mesh.hpp>

#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

TEST(AlongSegments, PointsAreGroupedBySegmentFromItsEndA) {
  Pslg pslg;
  pslg.points = {{0, 0}, {4, 0}};
  pslg.segments.resize(2);
  pslg.segments[0].a = pslg.segments[1].b = VertexId{0U};
  pslg.segments[0].b = pslg.segments[1].a = VertexId{1U};
  const SegmentId there{0U}, back{1U};
  const std::vector<PointOnSegment> points{
      {back, {1, 0}}, {there, {3, 0}}, {back, {2, 0}}, {there, {1, 0}}};
  const PointsAlong along = along_segments(pslg, points);
  EXPECT_EQ(along.order, (std::vector<std::uint32_t>{3, 1, 2, 0}));
  ASSERT_EQ(along.cuts.size(), 2U);
  EXPECT_EQ(along.cuts[0].segment, there);
  EXPECT_EQ(along.cuts[0].points, (std::vector<Point>{{1, 0}, {3, 0}}));
  EXPECT_EQ(along.cuts[1].segment, back);
  EXPECT_EQ(along.cuts[1].points, (std::vector<Point>{{2, 0}, {1, 0}}));
}

TEST(CutSegments, PiecesTakeThePlaceOfTheirSegment) {
  Result<Prepared> prepared = prepare(testing::checker(2, 1, 1));
  ASSERT_TRUE(prepared.has_value());
  Pslg pslg = prepared->pslg;
  RegionTable table = prepared->table;
  const std::size_t segments = pslg.segments.size(), points = pslg.points.size();

  const Segment cut = pslg.segments[3];
  const SegmentSides sides = table.sides[3];
  const Point a = pslg.points[cut.a.index()], b = pslg.points[cut.b.index()];
  const Point p{a.x + (b.x - a.x) / 4, a.y + (b.y - a.y) / 4};
  const Point q{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
  const std::vector<SegmentCut> cuts{{SegmentId{3}, {p, q}}};
  cut_segments(pslg, table, cuts);

  ASSERT_EQ(pslg.segments.size(), segments + 2);
  ASSERT_EQ(table.sides.size(), segments + 2);
  ASSERT_EQ(pslg.points.size(), points + 2);
  EXPECT_EQ(pslg.points[points], p);
  EXPECT_EQ(pslg.segments[3].a, cut.a);
  EXPECT_EQ(pslg.segments[3].b, VertexId{points});
  EXPECT_EQ(pslg.segments[4].b, VertexId{points + 1});
  EXPECT_EQ(pslg.segments[5].b, cut.b);
  for (std::size_t k = 3; k < 6; ++k) {
    EXPECT_EQ(table.sides[k].left, sides.left);
    EXPECT_EQ(table.sides[k].interface, sides.interface);
  }
  std::size_t listed = 0;
  for (const Interface& line : table.interfaces) {
    for (const SegmentId s : line.segments) {
      EXPECT_EQ(table.sides[s.index()].interface, line.id);
      ++listed;
    }
  }
  EXPECT_EQ(listed, segments + 2);
  std::size_t all_sides = 0;
  for (const RegionBoundary& boundary : split_regions(pslg, table)) {
    EXPECT_EQ(boundary.sides.size(), table.region(boundary.id).sides);
    all_sides += boundary.sides.size();
  }
  EXPECT_GT(all_sides, segments);
}

/// A segment in the void hangs on a corner of a square. A cut of the side beside it that is rounded
/// to its other side crosses nothing, and the point would be in the region.
TEST(CheckCuts, FindsWhatACutPassesInTheVoid) {
  const Result<Prepared> prepared = prepare(testing::segments_between(
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, -1e-3}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}}));
  ASSERT_TRUE(prepared.has_value());
  ASSERT_EQ(prepared->table.void_points, std::vector<VertexId>{VertexId{4U}});
  for (const double y : {0.0, -1e-2}) {
    Pslg pslg = prepared->pslg;
    RegionTable table = prepared->table;
    const std::size_t uncut = pslg.points.size();
    cut_segments(pslg, table, std::vector<SegmentCut>{{SegmentId{0U}, {{2, y}}}});
    const CdtResult whole = triangulate_whole(pslg);
    ASSERT_TRUE(whole.conflicts.empty());
    const std::vector<VertexId> passed = void_in_regions(pslg, table, whole.triangulation);
    EXPECT_EQ(passed.empty(), y == 0);
    const Status status = check_cuts(pslg, table, uncut);
    EXPECT_EQ(status.has_value(), y == 0);
    if (y == 0) continue;
    EXPECT_TRUE(std::binary_search(passed.begin(), passed.end(), VertexId{4U}));
    EXPECT_EQ(status.error().code, ErrorCode::meshing_incomplete);
    EXPECT_NE(status.error().message.find("lies in the void"), std::string::npos);
  }
}

}  // namespace
}  // namespace cover
