// Meshes under change for the tests of this folder, and what must hold of them at any time.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "cdt/cdt.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "support/inputs/shapes.hpp"

namespace cover::testing {

inline Goal default_goal() { return Goal::of(Angle::degrees(100), Angle::degrees(20)); }

/// The constrained Delaunay triangulation of a region, with the default goal.
inline MutableMesh cdt_mesh(const RegionBoundary& boundary, const Goal& goal = default_goal()) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const auto at = locate_sides(cdt, boundary.sides);
  MutableMesh mesh(cdt, static_cast<std::uint32_t>(boundary.points.size()), at,
                   side_limits(cdt, at));
  mesh.set_goal(goal);
  return mesh;
}

/// Neighbours are mutual, all triangles counter-clockwise, every side is there once, the stored
/// excess is the true one, homes are right, and the area is that of the region.
inline void expect_sound(const MutableMesh& mesh, const RegionBoundary& boundary) {
  double area = 0;
  std::vector<int> seen(mesh.sides.size(), 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    const MeshTriangle& m = mesh.triangles[t];
    ASSERT_EQ(orientation(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)), Sign::positive);
    area += cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0)) / 2;
    EXPECT_DOUBLE_EQ(mesh.excess[t], mesh.excess_of(m.v, m.n));
    for (const Corner i : kCorners) {
      const std::uint32_t a = m.v[i.next()], b = m.v[i.previous()];
      if (is_side(m.n[i])) {
        const std::uint32_t s = side_index(m.n[i]);
        EXPECT_EQ(boundary.sides[s], (IndexPair{a, b}));
        ++seen[s];
        continue;
      }
      const MeshTriangle& other = mesh.triangles[m.n[i]];
      const Corner j = other.edge_from(b);
      ASSERT_EQ(other.n[j], t);
      ASSERT_EQ(other.v[j.previous()], a);
    }
  }
  for (const int count : seen) EXPECT_EQ(count, 1);
  EXPECT_NEAR(area, area_of(boundary), 1e-12 * std::abs(area));
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.home[v] == kNone) continue;
    const auto& c = mesh.triangles[mesh.home[v]].v;
    EXPECT_TRUE(c[0] == v || c[1] == v || c[2] == v);
  }
}

/// The largest excess of any triangle.
inline double worst_excess(const MutableMesh& mesh) {
  double worst = -kInverted;
  for (const double e : mesh.excess) worst = std::max(worst, e);
  return worst;
}

/// A flower of five petals with n vertices: hard for a Delaunay triangulation.
inline RegionBoundary flower(int n) {
  Loop loop;
  for (int k = 0; k < n; ++k) {
    const double t = 2 * 3.14159265358979 * k / n, r = 1 + 0.2 * std::sin(5 * t);
    loop.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return boundary_of({loop});
}

}  // namespace cover::testing
