// See flip.hpp.
#include "quality/moves/flip.hpp"

#include <algorithm>

namespace cover {

bool try_flip(Piece& piece, std::uint32_t t) {
  if (piece.flips_left == 0) return false;
  MutableMesh& mesh = piece.mesh;
  int best_edge = -1;
  double best_gain = 0;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t u = mesh.triangles[t].n[static_cast<std::size_t>(i)];
    if (is_side(u)) continue;
    const double before = std::max(mesh.excess[t], mesh.excess[u]);
    const double limit = improvement_of(before);
    const double after = mesh.excess_after_flip(t, i, limit);
    if (!(after < limit)) continue;
    if (best_edge < 0 || before - after > best_gain) {
      best_edge = i;
      best_gain = before - after;
    }
  }
  if (best_edge < 0) return false;
  const std::uint32_t u = mesh.triangles[t].n[static_cast<std::size_t>(best_edge)];
  if (!mesh.flip(t, best_edge)) return false;
  --piece.flips_left;
  piece.look_around(t);
  piece.look_around(u);
  return true;
}

}  // namespace cover
