// See relocate.hpp.
#include "quality/moves/relocate.hpp"

#include <algorithm>

#include "quality/optimum/placement.hpp"

namespace cover {
namespace {

double worst_inside(const MutableMesh& mesh, const Cavity& cavity) {
  double worst = -kInverted;
  for (int k = 0; k < cavity.size(); ++k) worst = std::max(worst, mesh.excess[cavity.triangle(k)]);
  return worst;
}

}  // namespace

bool try_relocate(Workplace& work, std::uint32_t t) {
  MutableMesh& mesh = work.mesh;
  Cavity& cavity = work.cavity;
  const std::array<std::uint32_t, 3> corners = mesh.triangles[t].v;
  for (const std::uint32_t v : corners) {
    if (mesh.is_fixed(v) || !cavity.start_star(v)) continue;
    const double most = improvement_of(cavity.worst());
    const Point before = mesh.points[v];
    const Placement placement = place(Hole(mesh, cavity), before, most);
    work.evaluations += placement.evaluations;
    if (placement.worst < most && relocate(mesh, cavity, placement.at)) {
      // A hole and the mesh round in different ways: an excess that is no more than that would be
      // mended again and again, until the budget is used up, by leaving the vertex where it is.
      if (!(worst_inside(mesh, cavity) < cavity.worst())) {
        relocate(mesh, cavity, before);
        continue;
      }
      for (int k = 0; k < cavity.size(); ++k) {
        work.again.push_back(cavity.triangle(k));
        if (!is_side(cavity.outer(k))) work.again.push_back(cavity.outer(k));
      }
      return true;
    }
  }
  return false;
}

}  // namespace cover
