// See kick.hpp.
#include "quality/moves/kick.hpp"

#include "geom/vector.hpp"
#include "quality/mutable/cavity.hpp"
#include "quality/optimum/min_max_polygon.hpp"

namespace cover {

bool kick(MutableMesh& mesh, std::uint32_t t, int kind) {
  Cavity cavity(mesh);
  Installed installed;
  if (kind == 0) {
    cavity.start(t);
    const Point a = mesh.corner(t, 0);
    const Vector to_b = mesh.corner(t, 1) - a, to_c = mesh.corner(t, 2) - a;
    return install_star(mesh, cavity, a + (1.0 / 3) * (to_b + to_c), installed);
  }
  const int i = (kind - 1) % 3;
  if (kind <= 3) {
    cavity.start(t);
    return cavity.grow(i) &&
           install_star(mesh, cavity, midpoint(mesh.corner(t, i), mesh.corner(t, next3(i))),
                        installed);
  }
  if (kind <= 6) {
    return !is_side(mesh.triangles[t].n[static_cast<std::size_t>(i)]) && mesh.flip(t, i);
  }
  const std::uint32_t v = mesh.triangles[t].v[static_cast<std::size_t>(i)];
  Patch patch;
  return !mesh.is_fixed(v) && cavity.start_star(v) &&
         min_max_polygon(mesh, cavity, kInverted, patch) < kInverted &&
         install_patch(mesh, cavity, patch, installed);
}

}  // namespace cover
