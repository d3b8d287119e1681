// Tested by tests/unit/quality/mutable/mutable_mesh_test.cpp.
#include "quality/mutable/delaunay_flips.hpp"

#include "geom/predicates.hpp"

namespace cover {

std::size_t make_delaunay(MutableMesh& mesh) {
  std::vector<std::uint32_t> stack;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.is_hole(t)) stack.push_back(t);
  }
  std::size_t flips = 0;
  while (!stack.empty()) {
    const std::uint32_t t = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t u = mesh.triangles[t].n[static_cast<std::size_t>(i)];
      if (is_side(u)) continue;
      const int j = mesh.triangles[u].edge_from(mesh.triangles[t].v[
          static_cast<std::size_t>(prev3(i))]);
      if (in_circle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), mesh.corner(u, j)) !=
          Sign::positive)
        continue;
      if (!mesh.flip(t, i)) continue;
      ++flips;
      stack.push_back(t);
      stack.push_back(u);
      break;
    }
  }
  return flips;
}

}  // namespace cover
