#include <cover/adopt_cuts.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

/// A square of two triangles in which the diagonal is a segment.
Input cut_square() {
  Input input = testing::segments_between({{0, 0}, {3, 0}, {3, 3}, {0, 3}},
                                          {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 0}});
  for (InputSegment& s : input.segments) s.marker = static_cast<int>(10 * s.a + s.b);
  return input;
}

struct Clean {
  Pslg pslg;
  RegionTable table;
  Clean() {
    const Result<Prepared> prepared = prepare(cut_square());
    pslg = prepared->pslg;
    table = prepared->table;
  }
};

/// The diagonal is cut in three; numbers of vertices are not those of the input.
TriangleSoup cut_mesh() {
  TriangleSoup mesh;
  mesh.points = {{0, 3}, {2, 2}, {0, 0}, {1, 1}, {3, 0}, {3, 3}};
  mesh.triangles = {{2, 4, 3}, {3, 4, 1}, {1, 4, 5}, {0, 2, 3}, {0, 3, 1}, {0, 1, 5}};
  return mesh;
}

TEST(AdoptCuts, CutsSegmentsAndOrdersPoints) {
  Clean clean;
  const TriangleSoup mesh = cut_mesh();
  EXPECT_EQ(adopt_cuts(clean.pslg, clean.table, mesh), 2U);
  EXPECT_EQ(clean.pslg.points, mesh.points);
  ASSERT_EQ(clean.pslg.segments.size(), 7U);
  for (std::size_t s = 4; s < 7; ++s) EXPECT_EQ(clean.pslg.segments[s].marker, 20);
  EXPECT_EQ(clean.pslg.segments[4].a, VertexId{5});
  EXPECT_EQ(clean.pslg.segments[4].b, VertexId{1});
  EXPECT_EQ(clean.pslg.segments[5].b, VertexId{3});
  EXPECT_EQ(clean.pslg.segments[6].b, VertexId{2});
  EXPECT_EQ(verify_cover(clean.pslg, clean.table, mesh, {.bound = false, .materials = false})
                .violation_count,
            0U);
}

TEST(AdoptCuts, LeavesWholeSegmentsAlone) {
  Clean clean;
  TriangleSoup mesh;
  mesh.points = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Pslg before = clean.pslg;
  EXPECT_EQ(adopt_cuts(clean.pslg, clean.table, mesh), 0U);
  EXPECT_EQ(clean.pslg.points, before.points);
  EXPECT_EQ(clean.pslg.segments.size(), before.segments.size());
}

TEST(AdoptCuts, VerticesBesideASegmentAreNoCuts) {
  Clean clean;
  TriangleSoup mesh = cut_mesh();
  const double spacing = std::nextafter(3.0, 4.0) - 3;
  mesh.points[3] = {1, 1 + 4 * spacing};  // what rounding may do
  EXPECT_EQ(adopt_cuts(clean.pslg, clean.table, mesh), 2U);
  Clean again;
  mesh.points[3] = {1, 1 + 100 * spacing};
  EXPECT_EQ(adopt_cuts(again.pslg, again.table, mesh), 0U);
}

/// A slit's chain of points of the input within rounding of a cut segment: the sliver between them
/// is a region, and which way is the segment is told by whose points lie on it.
TEST(AdoptCuts, TellsACutSegmentFromPointsOfTheInputBesideIt) {
  const double low = 1 - 0x1p-53;  // beside (1, 1) by rounding
  const Input input =
      testing::segments_between({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, low}},
                                {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 0}, {0, 4}, {4, 2}});
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  ASSERT_EQ(prepared->table.regions.size(), 3U);
  TriangleSoup mesh;
  mesh.points = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, low}, {2, 2}};
  mesh.triangles = {{0, 1, 4}, {4, 1, 2}, {0, 4, 5}, {4, 2, 5}, {0, 5, 3}, {5, 2, 3}};
  const VerifyOptions split{.bound = false, .allow_split = true, .materials = false};
  const Verification uncut = verify_cover(prepared->pslg, prepared->table, mesh, split);
  EXPECT_EQ(uncut.violation_count, 0U) << uncut.violations[0].message;
  Pslg pslg = prepared->pslg;
  RegionTable table = prepared->table;
  EXPECT_EQ(adopt_cuts(pslg, table, mesh), 1U);
  const VerifyOptions whole{.bound = false, .materials = false};
  const Verification cut = verify_cover(pslg, table, mesh, whole);
  EXPECT_EQ(cut.violation_count, 0U) << cut.violations[0].message;
}

/// All sides of a sliver as thin as rounding are cut: no vertex tells which cut lies on which, but
/// the regions on both sides do.
TEST(AdoptCuts, TellsCutsOfSegmentsWithinRoundingByTheRegionsBesideThem) {
  const Input input =
      testing::segments_between({{0, 0},
                                 {1, 2 - 0x1p-52},
                                 {2 + 0x1.8p-50, 4 + 0x1p-49},
                                 {3 + 0x1.8p-50, 6 - 0x1.8p-49},
                                 {3, 29},
                                 {9, 2}},
                                {{0, 1}, {1, 2}, {2, 3}, {0, 4}, {4, 3}, {0, 3}, {5, 3}});
  Options options;
  options.method = Method::almond;
  options.fill = Fill::disks;
  const Result<Prepared> prepared = prepare(input, options);
  ASSERT_TRUE(prepared) << prepared.error().message;
  ASSERT_TRUE(prepared->report.changes.empty());
  options.split_interfaces = Angle::degrees(64);
  const Result<Output> output = cover_mesh(input, options);
  ASSERT_TRUE(output) << output.error().message;
  TriangleSoup mesh = triangle_soup(output->mesh);
  const VerifyOptions split{.bound = false, .allow_split = true};
  const Verification uncut = verify_cover(prepared->pslg, prepared->table, mesh, split);
  EXPECT_EQ(uncut.violation_count, 0U) << uncut.violations[0].message;
  Pslg pslg = prepared->pslg;
  RegionTable table = prepared->table;
  EXPECT_EQ(adopt_cuts(pslg, table, mesh), output->pslg.points.size() - input.points.size());
  const Verification cut = verify_cover(pslg, table, mesh, {});
  EXPECT_EQ(cut.violation_count, 0U) << cut.violations[0].message;
  // RegionIds vouch for nothing: a wrong one is told, and a missing triangle.
  mesh.region[0] = mesh.region[0] == 1 ? 2 : 1;
  EXPECT_GT(verify_cover(prepared->pslg, prepared->table, mesh, split).violation_count, 0U);
  mesh = triangle_soup(output->mesh);
  mesh.triangles.pop_back();
  mesh.region.pop_back();
  mesh.material.pop_back();
  EXPECT_GT(verify_cover(prepared->pslg, prepared->table, mesh, split).violation_count, 0U);
}

TEST(AdoptCuts, SurvivesAMeshOfSomethingElse) {
  Clean clean;
  TriangleSoup mesh;
  mesh.points = {{0, 0}, {1, 0}, {std::nan(""), 1}, {3, 3}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 7, 3}, {0, 3, 4}};
  EXPECT_EQ(adopt_cuts(clean.pslg, clean.table, mesh), 0U);
  EXPECT_EQ(clean.pslg.points.size(), 4U);
}

}  // namespace
}  // namespace cover
