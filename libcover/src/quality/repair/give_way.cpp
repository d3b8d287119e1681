// Tested by tests/unit/quality/repair/give_way_test.cpp.
#include "quality/repair/give_way.hpp"

#include <optional>
#include <vector>

#include "quality/mutable/cavity.hpp"
#include "quality/optimum/delaunay_polygon.hpp"

namespace cover {
namespace {

/// The free corner of `t` that makes the coupling of the side opposite to it negative.
std::optional<std::uint32_t> vertex_in_the_way(const MutableMesh& mesh, std::uint32_t t) {
  const MeshTriangle& triangle = mesh.triangles[t];
  for (const Corner i : kCorners) {
    const std::uint32_t side = triangle.n[i];
    if (!is_side(side) || mesh.is_fixed(triangle.v[i])) continue;
    const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    const double least = mesh.sides[side_index(side)].least_cot;
    if (!(k.cross > 0) || k.dot[i] < least * k.cross) return triangle.v[i];
  }
  return std::nullopt;
}

}  // namespace

std::size_t give_way_to_sides(MutableMesh& mesh) {
  std::vector<std::uint32_t> left;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.is_hole(t) && vertex_in_the_way(mesh, t)) left.push_back(t);
  }
  std::size_t gone = 0;
  Cavity cavity(mesh);
  Patch patch;
  Installed installed;
  while (!left.empty()) {
    const std::uint32_t t = left.back();
    left.pop_back();
    if (mesh.is_hole(t)) continue;
    const std::optional<std::uint32_t> v = vertex_in_the_way(mesh, t);
    if (!v || !cavity.start_star(*v) || !(delaunay_polygon(mesh, cavity, patch) < kInverted) ||
        !install_patch(mesh, cavity, patch, installed))
      continue;
    ++gone;
    for (int k = 0; k < installed.count; ++k)
      left.push_back(installed.triangles[static_cast<std::size_t>(k)]);
  }
  return gone;
}

}  // namespace cover
