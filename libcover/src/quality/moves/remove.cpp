// See remove.hpp.
#include "quality/moves/remove.hpp"

#include "quality/optimum/min_max_polygon.hpp"

namespace cover {

bool try_remove(Workplace& work, std::uint32_t t) {
  MutableMesh& mesh = work.mesh;
  Cavity& cavity = work.cavity;
  const std::array<std::uint32_t, 3> corners = mesh.triangles[t].v;
  for (const std::uint32_t v : corners) {
    if (mesh.is_fixed(v) || !cavity.start_star(v) || cavity.size() > kPolygonLimit) continue;
    Patch patch;
    const double worst = min_max_polygon(mesh, cavity, cavity.worst(), patch);
    ++work.evaluations;
    if (worst <= cavity.worst() && install_patch(mesh, cavity, patch, work.installed)) {
      work.look_around_installed();
      return true;
    }
  }
  return false;
}

}  // namespace cover
