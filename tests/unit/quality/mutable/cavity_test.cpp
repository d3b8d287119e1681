#include "quality/mutable/cavity.hpp"

#include "../grow_fully.hpp"
#include "../mesh_checks.hpp"
#include "quality/optimum/min_max_polygon.hpp"

namespace cover {
namespace {

using namespace testing;

/// A square of 2 x 2 cells, without the vertex in its middle.
RegionBoundary window() {
  return boundary_of({{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}});
}

TEST(Cavity, GrowsToADiskAndNotBeyondSides) {
  const MutableMesh mesh = cdt_mesh(window());
  Cavity cavity(mesh);
  cavity.start(0);
  EXPECT_EQ(cavity.size(), 3);
  grow_fully(cavity);
  EXPECT_EQ(cavity.triangle_count(), 6);
  EXPECT_EQ(cavity.size(), 8);
  for (int k = 0; k < cavity.size(); ++k) EXPECT_TRUE(is_side(cavity.outer(k)));
  EXPECT_EQ(cavity.swallowed_count(), 0);
}

TEST(Cavity, StarThenRemovalGivesSoundMeshes) {
  const RegionBoundary boundary = window();
  MutableMesh mesh = cdt_mesh(boundary);
  Cavity cavity(mesh);
  cavity.start(0);
  grow_fully(cavity);
  Installed installed;
  ASSERT_TRUE(install_star(mesh, cavity, {1, 1}, installed));
  EXPECT_EQ(installed.count, 8);
  EXPECT_EQ(mesh.triangle_count(), 8u);
  expect_sound(mesh, boundary);
  EXPECT_LT(worst_excess(mesh), 0);

  const std::uint32_t centre = 8;
  ASSERT_TRUE(cavity.start_star(centre));
  EXPECT_EQ(cavity.size(), 8);
  Patch patch;
  EXPECT_LT(min_max_polygon(mesh, cavity, kInverted, patch), kInverted);
  ASSERT_TRUE(install_patch(mesh, cavity, patch, installed));
  EXPECT_EQ(mesh.triangle_count(), 6u);
  EXPECT_EQ(mesh.home[centre], kNone);
  expect_sound(mesh, boundary);
}

TEST(Cavity, SwallowsAFreeVertex) {
  const RegionBoundary boundary = window();
  MutableMesh mesh = cdt_mesh(boundary);
  Cavity cavity(mesh);
  cavity.start(0);
  Installed installed;
  const Point middle = midpoint(midpoint(mesh.corner(0, 0), mesh.corner(0, 1)), mesh.corner(0, 2));
  ASSERT_TRUE(install_star(mesh, cavity, middle, installed));
  expect_sound(mesh, boundary);
  cavity.start(installed.triangles[0]);
  while (cavity.swallowed_count() == 0) {
    int k = 0;
    while (mesh.is_fixed(cavity.vertex(k))) ++k;
    ASSERT_TRUE(cavity.grow(k));
  }
  EXPECT_EQ(cavity.triangle_count(), 3);
  EXPECT_EQ(cavity.size(), 3);
}

TEST(Cavity, RefusesAStarThatIsNotCounterClockwise) {
  const RegionBoundary boundary = window();
  MutableMesh mesh = cdt_mesh(boundary);
  Cavity cavity(mesh);
  cavity.start(0);
  Installed installed;
  EXPECT_FALSE(install_star(mesh, cavity, {5, 5}, installed));
  EXPECT_FALSE(install_star(mesh, cavity, mesh.corner(0, 1), installed));
  expect_sound(mesh, boundary);
}

TEST(Cavity, IsNotFilledByTooFewTriangles) {
  MutableMesh mesh = cdt_mesh(window());
  Cavity cavity(mesh);
  cavity.start(0);
  grow_fully(cavity);
  Installed installed;
  Patch patch;  // what is found where rounding leaves every triangle flat
  EXPECT_FALSE(install_patch(mesh, cavity, patch, installed));
  EXPECT_EQ(mesh.triangle_count(), 6U);
  expect_sound(mesh, window());
}

}  // namespace
}  // namespace cover
