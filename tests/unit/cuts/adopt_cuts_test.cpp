#include <cover/remesh.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <cover/cover_mesh.hpp>

#include "support/inputs.hpp"

namespace cover {
namespace {

/// A square of two triangles in which the diagonal is a segment.
Input square() {
  Input input = testing::segments_between({{0, 0}, {3, 0}, {3, 3}, {0, 3}},
                                          {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 0}});
  for (InputSegment& s : input.segments) s.marker = static_cast<int>(10 * s.a + s.b);
  return input;
}

struct Clean {
  Pslg pslg;
  RegionTable table;
  Clean() {
    const Result<Prepared> prepared = prepare(square());
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
