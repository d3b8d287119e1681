// Meshes whose couplings count, for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cdt/couplings.hpp"
#include "mesh_checks.hpp"
#include "quality/starts/delaunay_refinement.hpp"

namespace cover::testing {

/// As by default: couplings before targets.
inline Goal strict_goal() {
  Goal goal = default_goal();
  goal.coupling = {kCouplingFirst, true, true, 1 / std::tan(std::numbers::pi / 6)};
  return goal;
}

inline Goal soft_goal() {
  Goal goal = default_goal();
  goal.coupling = {1, true, false, kInverted};
  return goal;
}

/// A constrained Delaunay triangulation whose free sides mind couplings.
inline MutableMesh minding_mesh(const RegionBoundary& boundary, const Goal& goal) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const auto at = locate_sides(cdt, boundary.sides);
  std::vector<SideLimit> limits = side_limits(cdt, at);
  mind_free_sides(cdt, at, limits);
  MutableMesh mesh(cdt, static_cast<std::uint32_t>(boundary.points.size()), at, limits);
  mesh.set_goal(goal);
  return mesh;
}

/// The same, refined by `budget` insertions at the most, so that moves have something to do.
inline MutableMesh refined_minding_mesh(const RegionBoundary& boundary, const Goal& goal,
                                        std::size_t budget) {
  MutableMesh mesh = minding_mesh(boundary, goal);
  RefineLimits limits;
  limits.smallest_cot = 2;
  limits.budget = budget;
  refine(mesh, limits);
  return mesh;
}

inline std::vector<IndexTriple> triangles_of(const MutableMesh& mesh) {
  std::vector<IndexTriple> triangles;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.is_hole(t)) triangles.push_back(mesh.triangles[t].v);
  }
  return triangles;
}

inline std::size_t negative_inside(const MutableMesh& mesh, const RegionBoundary& boundary) {
  const auto found = negative_edges(mesh.points, triangles_of(mesh), boundary.sides);
  return static_cast<std::size_t>(
      std::count_if(found.begin(), found.end(), [](const auto& e) { return !e.is_side; }));
}

}  // namespace cover::testing
