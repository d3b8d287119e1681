#include <gtest/gtest.h>

#include <cover/mesh.hpp>
#include <utility>

namespace cover {
namespace {

/// One triangle with everything that a Mesh knows about it.
Mesh one_triangle() {
  Mesh mesh;
  TriMesh& tri = mesh.tri();
  const auto a = tri.add_vertex({0, 0, 0}), b = tri.add_vertex({1, 0, 0}),
             c = tri.add_vertex({0, 1, 0});
  const auto f = tri.add_face(a, b, c);
  mesh.set_region(f, RegionId(3));
  mesh.set_material(f, 7);
  mesh.set_input_id(b, 11);
  mesh.set_marker(tri.edge_handle(tri.find_halfedge(a, b)), 5);
  return mesh;
}

void expect_one_triangle(const Mesh& mesh) {
  ASSERT_EQ(mesh.triangles(), 1U);
  ASSERT_EQ(mesh.vertices(), 3U);
  const auto f = *mesh.tri().faces_begin();
  EXPECT_EQ(mesh.region(f), RegionId(3));
  EXPECT_EQ(mesh.material(f), 7);
  EXPECT_EQ(mesh.input_id(TriMesh::VertexHandle(1)), 11);
  const auto edge = mesh.tri().edge_handle(
      mesh.tri().find_halfedge(TriMesh::VertexHandle(0), TriMesh::VertexHandle(1)));
  EXPECT_EQ(mesh.marker(edge), 5);
}

TEST(Mesh, ACopyHasPropertiesOfItsOwn) {
  const Mesh mesh = one_triangle();
  Mesh copy = mesh;
  expect_one_triangle(copy);
  copy.set_material(*copy.tri().faces_begin(), 8);
  expect_one_triangle(mesh);
  EXPECT_EQ(copy.material(*copy.tri().faces_begin()), 8);
}

TEST(Mesh, MovesKeepEverythingAndWhatIsLeftCanBeAssignedTo) {
  Mesh mesh = one_triangle();
  Mesh moved = std::move(mesh);
  expect_one_triangle(moved);
  mesh = moved;
  expect_one_triangle(mesh);
}

TEST(Mesh, OneThatWasMovedFromIsEmptyAndOfUse) {
  Mesh mesh = one_triangle();
  const Mesh moved = std::move(mesh);
  const Mesh& left = mesh;  // NOLINT(bugprone-use-after-move): that is the point
  EXPECT_EQ(left.vertices(), 0U);
  EXPECT_EQ(left.triangles(), 0U);
  EXPECT_EQ(left.tri().n_edges(), 0U);
  const Mesh copy = left;
  EXPECT_EQ(copy.triangles(), 0U);
  const auto v = mesh.tri().add_vertex({1, 2, 0});
  mesh.set_input_id(v, 4);
  EXPECT_EQ(left.input_id(v), 4);
  EXPECT_EQ(copy.vertices(), 0U);
  expect_one_triangle(moved);
}

}  // namespace
}  // namespace cover
