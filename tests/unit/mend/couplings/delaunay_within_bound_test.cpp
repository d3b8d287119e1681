#include "mend/couplings/delaunay_within_bound.hpp"

#include <gtest/gtest.h>

#include "cdt/region_cdt.hpp"
#include "region/whole_mesh.hpp"
#include "support/inputs/shapes.hpp"
#include "target/report/fill_report.hpp"

namespace cover {
namespace {

/// The end of a wedge, whose rows end in two far corners: an inner vertex lies 0.1 beside the line
/// of its neighbours, so that the constrained Delaunay triangulation has a flat triangle there.
RegionBoundary wedge() {
  RegionBoundary boundary;
  boundary.id = RegionId{1};
  boundary.points = {{0, -5}, {660, -5}, {660, 5}, {0, 5}, {-40, 6.6}, {-40, -6.6}};
  for (std::uint32_t k = 0; k < 6; ++k) {
    boundary.vertices.push_back(VertexId{k});
    boundary.sides.push_back({k, (k + 1) % 6});
    boundary.segments.push_back(SegmentId{k});
  }
  return boundary;
}

RegionMesh mesh_of(const RegionBoundary& boundary) {
  RegionMesh mesh;
  mesh.steiner = {{-0.1, 1.6}};
  mesh.triangles = {{6, 3, 4}, {6, 4, 5}, {6, 5, 0}, {0, 1, 6}, {1, 3, 6}, {1, 2, 3}};
  mesh.report.id = boundary.id;
  mesh.report.nu_bound = Angle::degrees(30);
  fill_report(boundary, mesh);
  EXPECT_TRUE(mesh.report.bound_held);
  EXPECT_EQ(mesh.report.box.negative_inside, 1U);
  return mesh;
}

void expect_sound(const RegionBoundary& boundary, const RegionMesh& mesh) {
  EXPECT_TRUE(mesh.report.bound_held);
  EXPECT_EQ(mesh.report.box.negative_inside, 0U);
  EXPECT_EQ(mesh.report.box.negative_given_up, 0U);
  EXPECT_FALSE(find_flaw({all_points(boundary, mesh), mesh.triangles, boundary.sides,
                          boundary.segments, boundary.points.size()}));
}

TEST(DelaunayWithinBound, TakesAVertexOfALayerAway) {
  const RegionBoundary boundary = wedge();
  RegionMesh mesh = mesh_of(boundary);
  mesh.layer_vertices = 1;
  mesh.layer_triangles = 6;  // among which no other vertex is put
  const auto mended = mend_couplings_within_bound(boundary, mesh, {});
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->layer_vertices, 0U);
  EXPECT_EQ(mended->layer_triangles, 4U);
  expect_sound(boundary, *mended);
}

TEST(DelaunayWithinBound, PutsVerticesElsewhereFirst) {
  const RegionBoundary boundary = wedge();
  RegionMesh mesh = mesh_of(boundary);
  mesh.layer_vertices = 1;
  mesh.layer_triangles = 3;
  const auto mended = mend_couplings_within_bound(boundary, mesh, {});
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->layer_vertices, 1U);
  EXPECT_EQ(mended->steiner[0], mesh.steiner[0]);
  EXPECT_EQ(mended->layer_triangles, 3U);
  expect_sound(boundary, *mended);
}

TEST(DelaunayWithinBound, MovesAnyOther) {
  const RegionBoundary boundary = wedge();
  const auto mended = mend_couplings_within_bound(boundary, mesh_of(boundary), {});
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->layer_triangles, 0U);
  expect_sound(boundary, *mended);
  // What is so already stays.
  EXPECT_FALSE(mend_couplings_within_bound(boundary, *mended, {}));
}

TEST(DelaunayWithinBound, LeavesWhatCannotBeMended) {
  RegionBoundary boundary = wedge();
  RegionMesh mesh = mesh_of(boundary);
  mesh.report.nu_bound = Angle::degrees(100);  // angles of 80 at most, which no polygon here has
  fill_report(boundary, mesh);
  EXPECT_FALSE(mend_couplings_within_bound(boundary, mesh, {}));
  mesh.report.nu_bound = Angle::degrees(30);
  boundary.segments[0] = kHullSide;  // may be split, so that nothing is known of the mesh there
  EXPECT_FALSE(mend_couplings_within_bound(boundary, mesh, {}));
}

/// A grain of a picture: there is room for vertices only in its middle and in cusps beside its flat
/// corners, where the discs over the two sides beside each leave some.
TEST(DelaunayWithinBound, FindsRoomInCusps) {
  const RegionBoundary boundary = testing::boundary_of({{{196, 190},
                                                         {197.427, 190.276},
                                                         {199.573, 190.872},
                                                         {207.772, 193.913},
                                                         {209.699, 194.848},
                                                         {210.648, 195.587},
                                                         {211, 196},
                                                         {201, 207},
                                                         {191, 206},
                                                         {190.58, 204.67},
                                                         {190.273, 203.227},
                                                         {190.08, 201.67},
                                                         {190, 200},
                                                         {190, 192}}});
  RegionMesh mesh;
  mesh.steiner = {{209.774, 196.075}};
  std::vector<Point> points = boundary.points;
  points.push_back(mesh.steiner[0]);
  for (const Triangle& t : triangulate_region(points, boundary.sides).triangles)
    mesh.triangles.push_back(t.v);
  mesh.report.id = boundary.id;
  mesh.report.nu_bound = Angle::degrees(30);
  fill_report(boundary, mesh);
  EXPECT_TRUE(mesh.report.bound_held);
  EXPECT_EQ(mesh.report.box.negative_inside, 0U);
  EXPECT_EQ(mesh.report.box.negative_given_up, 1U);
  EXPECT_EQ(mesh.report.box.negative_forced, 0U);
  const auto mended = mend_couplings_within_bound(boundary, mesh, {});
  ASSERT_TRUE(mended);
  expect_sound(boundary, *mended);
  EXPECT_EQ(mended->report.box.negative_couplings, 0U);
}

}  // namespace
}  // namespace cover
