#include "quality/starts/delaunay_refinement.hpp"

#include <stop_token>

#include "../mesh_checks.hpp"
#include "../refine_limits.hpp"
#include "quality/fault/merit.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(Refine, RemovesSmallAnglesAndStaysDelaunay) {
  const RegionBoundary boundary = flower(200);
  MutableMesh mesh = cdt_mesh(boundary);
  refine(mesh, limits_of(20));
  expect_sound(mesh, boundary);
  EXPECT_LT(mesh.triangle_count(), 4 * 200u);
  EXPECT_LE(merit_of(mesh, mesh.goal()).small, 1 / std::tan(19.999 * 3.14159265 / 180));
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Corner i : kCorners) {
      const std::uint32_t n = mesh.triangles[t].n[i];
      if (is_side(n)) continue;
      for (const std::uint32_t v : mesh.triangles[n].v) {
        EXPECT_NE(
            in_circle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), mesh.points[v]),
            Sign::positive);
      }
    }
  }
}

TEST(Refine, KeepsOutOfForcedTriangles) {
  const RegionBoundary boundary = boundary_of({{{0, 0}, {10, 0}, {10, 5}, {5, 0.5}, {0, 5}}});
  MutableMesh mesh = cdt_mesh(boundary);
  refine(mesh, limits_of(20));
  expect_sound(mesh, boundary);
  const Merit merit = merit_of(mesh, mesh.goal());
  double forced = 0;
  for (const SideLimit& side : mesh.sides) forced = std::max(forced, -side.apex_cot);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Corner i : kCorners) {
      const std::uint32_t n = mesh.triangles[t].n[i];
      if (!is_side(n) || mesh.allowances[side_index(n)].large == 0) continue;
      const Corners k(mesh.corner(t, i), mesh.corner(t, i.next()), mesh.corner(t, i.previous()));
      EXPECT_NEAR(k.dot[0] / k.cross, mesh.sides[side_index(n)].apex_cot, 1e-9);
    }
  }
  EXPECT_GE(merit.large, forced);
}

/// The mesh is of no use then, but nobody waits for it.
TEST(Refine, EndsOnceAStopIsRequested) {
  std::stop_source source;
  MutableMesh mesh = cdt_mesh(flower(200));
  const std::size_t before = mesh.triangle_count();
  source.request_stop();
  refine(mesh, limits_of(20), {}, {.stop = source.get_token()});
  EXPECT_EQ(mesh.triangle_count(), before);
  refine(mesh, limits_of(20));
  EXPECT_GT(mesh.triangle_count(), before);
}

}  // namespace
}  // namespace cover
