#include "quality/optimum/delaunay_polygon.hpp"

#include <random>

#include "../coupled_meshes.hpp"
#include "quality/mutable/cavity.hpp"
#include "quality/mutable/delaunay_flips.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(DelaunayPolygon, FillsAHoleAsDelaunayDoes) {
  std::mt19937_64 random(8);
  const RegionBoundary boundary = boundary_of({random_star(40, 0.6, random)});
  MutableMesh mesh = refined_minding_mesh(boundary, soft_goal(), 400);
  make_delaunay(mesh);
  std::size_t removed = 0;
  Cavity cavity(mesh);
  for (std::uint32_t v = mesh.fixed_vertices(); v < mesh.points.size(); v += 2) {
    if (mesh.home[v] == kNone || !cavity.start_star(v)) continue;
    Patch patch;
    ASSERT_LT(delaunay_polygon(mesh, cavity, patch), kInverted);
    Installed installed;
    ASSERT_TRUE(install_patch(mesh, cavity, patch, installed));
    ASSERT_EQ(negative_inside(mesh, boundary), 0u);
    ++removed;
  }
  EXPECT_GT(removed, 5u);
  expect_sound(mesh, boundary);
}

}  // namespace
}  // namespace cover
