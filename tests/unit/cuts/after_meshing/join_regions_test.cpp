#include "cuts/after_meshing/join_regions.hpp"

#include <gtest/gtest.h>

namespace cover {
namespace {

JoinedMesh two_triangles() {
  JoinedMesh mesh;
  mesh.points = {{1, 1}, {0, 0}, {1, 0}, {0, 1}};
  mesh.line = {JoinedMesh::kFixed, JoinedMesh::kInside, 0, JoinedMesh::kFixed};
  mesh.lines = {{{1, 0}, {0, 0}}};
  mesh.pieces = {{1, 2, 0}};
  mesh.triangles = {{2, 0, 1}, {0, 3, 1}};
  mesh.region = {0, 1};
  return mesh;
}

TEST(JoinRegions, IsSortedByPlaces) {
  JoinedMesh mesh = two_triangles();
  EXPECT_EQ(sort_by_place(mesh), (std::vector<std::uint32_t>{1, 3, 2, 0}));
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
  EXPECT_EQ(mesh.line[0], JoinedMesh::kInside);
  EXPECT_EQ(mesh.line[2], 0u);
  EXPECT_EQ(mesh.triangles, (std::vector<IndexTriple>{{0, 2, 3}, {0, 3, 1}}));
  EXPECT_EQ(mesh.region, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(mesh.pieces[0].a, 0u);
  EXPECT_EQ(mesh.pieces[0].b, 2u);
}

TEST(JoinRegions, NumbersGoBack) {
  const JoinedMesh before = two_triangles();
  JoinedMesh mesh = before;
  renumber({2, 3, 1, 0}, mesh);
  EXPECT_EQ(mesh.points[2], before.points[0]);
  renumber({3, 2, 0, 1}, mesh);
  EXPECT_EQ(mesh.points, before.points);
  EXPECT_EQ(mesh.triangles, before.triangles);
  EXPECT_EQ(mesh.line, before.line);
}

}  // namespace
}  // namespace cover
