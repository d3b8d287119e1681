#include "quality/parts/excerpt.hpp"

#include <algorithm>
#include <random>

#include "../coupled_meshes.hpp"
#include "../mesh_checks.hpp"
#include "quality/repair/improve.hpp"
#include "quality/starts/restart.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(Excerpt, PutsImprovedPartsBack) {
  const RegionBoundary boundary = flower(200);
  MutableMesh mesh = cdt_mesh(boundary);
  const double before = worst_excess(mesh);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t) || !(mesh.excess[t] > 0)) continue;
    const Excerpt excerpt(mesh, t, 40);
    MutableMesh part = excerpt.mesh;
    EXPECT_TRUE(part.is_valid());
    EXPECT_LE(part.triangle_count(), 40u);
    improve(part, 10000);
    for (const std::uint32_t place : excerpt.replace(mesh, part)) EXPECT_FALSE(mesh.is_hole(place));
  }
  expect_sound(mesh, boundary);
  EXPECT_GT(mesh.points.size(), boundary.points.size());
  EXPECT_LT(worst_excess(mesh), before);
}

TEST(Excerpt, OfAllTrianglesIsTheWhole) {
  const RegionBoundary boundary = flower(20);
  MutableMesh mesh = cdt_mesh(boundary);
  const Excerpt excerpt(mesh, 0, 1000);
  EXPECT_EQ(excerpt.mesh.triangle_count(), mesh.triangle_count());
  EXPECT_EQ(excerpt.mesh.fixed_vertices(), mesh.fixed_vertices());
  EXPECT_EQ(worst_excess(excerpt.mesh), worst_excess(mesh));
  excerpt.replace(mesh, excerpt.mesh);
  expect_sound(mesh, boundary);
}

TEST(Excerpt, DropsVerticesThatAPartHasNoMore) {
  const RegionBoundary boundary = flower(40);
  MutableMesh mesh = *restart(cdt_mesh(boundary), 30, 1);
  const Excerpt excerpt(mesh, 0, 1000);
  excerpt.replace(mesh, *restart(excerpt.mesh, 4, 2));
  expect_sound(mesh, boundary);
  EXPECT_EQ(std::count_if(mesh.home.begin(), mesh.home.end(), [](auto t) { return t != kNone; }),
            static_cast<std::ptrdiff_t>(boundary.points.size() + 4));
}

TEST(Excerpt, MindsWhatIsAcrossItsBorder) {
  std::mt19937_64 random(9);
  const RegionBoundary boundary = boundary_of({random_star(60, 0.6, random)});
  MutableMesh mesh = refined_minding_mesh(boundary, strict_goal(), 400);
  mesh.measure_all();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t += 7) {
    if (mesh.is_hole(t)) continue;
    const Excerpt excerpt(mesh, t, 12);
    MutableMesh improved = excerpt.mesh;
    improve(improved, 2000);
    excerpt.replace(mesh, improved);
    ASSERT_EQ(negative_inside(mesh, boundary), 0u) << t;
  }
  expect_sound(mesh, boundary);
}

}  // namespace
}  // namespace cover
