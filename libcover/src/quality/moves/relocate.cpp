// See relocate.hpp. Tested by tests/unit/quality/repair/improve_test.cpp.
#include "quality/moves/relocate.hpp"

#include "quality/optimum/placement.hpp"

namespace cover {

bool try_relocate(Piece& piece, std::uint32_t t) {
  MutableMesh& mesh = piece.mesh;
  Cavity& cavity = piece.cavity;
  const std::array<std::uint32_t, 3> corners = mesh.triangles[t].v;
  for (const std::uint32_t v : corners) {
    if (mesh.is_fixed(v) || !cavity.start_star(v)) continue;
    const double limit = improvement_of(cavity.worst());
    const Placement placement = place(Hole(mesh, cavity), mesh.points[v], limit, piece.evaluations);
    if (placement.worst < limit && relocate(mesh, cavity, placement.at)) {
      for (int k = 0; k < cavity.size(); ++k) {
        piece.again.push_back(cavity.triangle(k));
        if (!is_side(cavity.outer(k))) piece.again.push_back(cavity.outer(k));
      }
      return true;
    }
  }
  return false;
}

}  // namespace cover
