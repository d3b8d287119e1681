#include "quality/mutable/delaunay_flips.hpp"

#include <random>

#include "../coupled_meshes.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(DelaunayFlips, MakeTheMeshDelaunay) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 20; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(60, 0.4, random)});
    MutableMesh mesh = minding_mesh(boundary, soft_goal());
    std::size_t spoiled = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const std::uint32_t u = mesh.triangles[t].n[t % 3];
      if (!is_side(u) && mesh.flip(t, t % 3)) ++spoiled;
    }
    expect_sound(mesh, boundary);
    ASSERT_GT(spoiled, 0u);
    EXPECT_GT(make_delaunay(mesh), 0u);
    EXPECT_EQ(negative_inside(mesh, boundary), 0u);
    expect_sound(mesh, boundary);
    EXPECT_EQ(make_delaunay(mesh), 0u);
  }
}

}  // namespace
}  // namespace cover
