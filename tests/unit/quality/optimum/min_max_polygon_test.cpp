#include "quality/optimum/min_max_polygon.hpp"

#include "../grow_fully.hpp"
#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(MinMaxPolygon, FindsTheBestTriangulation) {
  // Of a flat hexagon: the zigzag is better than every fan.
  const RegionBoundary boundary =
      boundary_of({{{0, 0}, {1, -0.1}, {2, 0}, {2, 1}, {1, 1.1}, {0, 1}}});
  MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(100), Angle::degrees(0)));
  Cavity cavity(mesh);
  cavity.start(0);
  grow_fully(cavity);
  ASSERT_EQ(cavity.size(), 6);
  Patch patch;
  const double best = min_max_polygon(mesh, cavity, kInverted, patch);
  EXPECT_EQ(patch.count(), 4);
  Installed installed;
  ASSERT_TRUE(install_patch(mesh, cavity, patch, installed));
  EXPECT_DOUBLE_EQ(worst_excess(mesh), best);
  EXPECT_LE(best, 0);
  expect_sound(mesh, boundary);
}

TEST(MinMaxPolygon, NeedsTwoEars) {
  const RegionBoundary boundary = boundary_of({regular_polygon(7, 1)});  // corners of 128 degrees
  const MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(100), Angle::degrees(0)));
  Cavity cavity(mesh);
  cavity.start(0);
  grow_fully(cavity);
  Patch patch;
  EXPECT_EQ(min_max_polygon(mesh, cavity, 0, patch), kInverted);
  EXPECT_GT(min_max_polygon(mesh, cavity, kInverted, patch), 0);
  EXPECT_EQ(patch.count(), 5);
}

}  // namespace
}  // namespace cover
