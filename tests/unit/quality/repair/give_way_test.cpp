#include "quality/repair/give_way.hpp"

#include "../mesh_checks.hpp"
#include "quality/fault/merit.hpp"
#include "quality/mutable/cavity.hpp"
#include "quality/mutable/delaunay_flips.hpp"
#include "target/side_limit.hpp"

namespace cover {
namespace {

using namespace testing;

Goal with_couplings() {
  Goal goal = Goal::of(Angle::degrees(100), Angle::degrees(20));
  goal.coupling = {kCouplingFirst, true, true, kInverted};
  return goal;
}

/// The constrained Delaunay triangulation, minding the sides that no given vertex encroaches.
MutableMesh mesh_with_free_sides(const RegionBoundary& boundary) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const std::vector<EdgeRef> at = locate_sides(cdt, boundary.sides);
  std::vector<SideLimit> limits = side_limits(cdt, at);
  mind_free_sides(cdt, at, limits);
  return MutableMesh(cdt, static_cast<std::uint32_t>(boundary.points.size()), at,
                     SideLimits(std::move(limits)));
}

TEST(GiveWay, LeavesNoNegativeCouplingOfAFreeSide) {
  const RegionBoundary boundary = boundary_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  MutableMesh mesh = mesh_with_free_sides(boundary);
  mesh.set_goal(with_couplings());
  Cavity cavity(mesh);
  cavity.start(0);
  const Point centroid = mesh.corner(0, 0) + (1.0 / 3) * ((mesh.corner(0, 1) - mesh.corner(0, 0)) +
                                                          (mesh.corner(0, 2) - mesh.corner(0, 0)));
  Installed installed;
  ASSERT_TRUE(install_star(mesh, cavity, centroid, installed));
  make_delaunay(mesh);
  ASSERT_GT(merit_of(mesh, with_couplings()).negative, 0u);  // two sides see it at 117 degrees
  EXPECT_EQ(give_way_to_sides(mesh), 1u);
  expect_sound(mesh, boundary);
  EXPECT_EQ(mesh.triangle_count(), 2u);
  EXPECT_EQ(merit_of(mesh, with_couplings()).negative, 0u);
}

TEST(GiveWay, LeavesAMeshWithoutNegativeCouplingsAsItIs) {
  const RegionBoundary boundary = flower(300);
  MutableMesh mesh = mesh_with_free_sides(boundary);
  mesh.set_goal(with_couplings());
  const std::size_t triangles = mesh.triangle_count();
  EXPECT_EQ(give_way_to_sides(mesh), 0u);
  EXPECT_EQ(mesh.triangle_count(), triangles);
}

}  // namespace
}  // namespace cover
