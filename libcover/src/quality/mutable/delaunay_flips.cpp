// Tested by tests/unit/quality/couplings_test.cpp.
#include "quality/mutable/delaunay_flips.hpp"

#include "geom/predicates.hpp"

namespace cover {

namespace {

/// Whether edge i of `t`, if it is no side, has a negative coupling.
bool is_negative(const MutableMesh& mesh, std::uint32_t t, int i) {
  const std::uint32_t u = mesh.triangles[t].n[static_cast<std::size_t>(i)];
  const std::uint32_t from = mesh.triangles[t].v[static_cast<std::size_t>(prev3(i))];
  return in_circle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2),
                   mesh.corner(u, mesh.triangles[u].edge_from(from))) == Sign::positive;
}

}  // namespace

std::size_t make_delaunay(MutableMesh& mesh) {
  std::size_t flips = 0;
  std::vector<std::uint32_t> stack;
  /// Flips one edge of `t`, if it has to be, among those to triangles from `first` on.
  const auto flip_one = [&](std::uint32_t t, std::uint32_t first) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t u = mesh.triangles[t].n[static_cast<std::size_t>(i)];
      if (is_side(u) || u < first || !is_negative(mesh, t, i) || !mesh.flip(t, i)) continue;
      ++flips;
      stack.push_back(t);
      stack.push_back(u);
      return;
    }
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.is_hole(t)) flip_one(t, t);
    while (!stack.empty()) {
      const std::uint32_t changed = stack.back();
      stack.pop_back();
      flip_one(changed, 0);
    }
  }
  return flips;
}

}  // namespace cover
