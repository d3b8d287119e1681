// See flip.hpp.
#include "quality/moves/flip.hpp"

#include <algorithm>
#include <optional>

namespace cover {

bool try_flip(Workplace& work, std::uint32_t t) {
  if (work.flips_left == 0) return false;
  MutableMesh& mesh = work.mesh;
  std::optional<Corner> best_edge;
  double best_gain = 0;
  for (const Corner i : kCorners) {
    const std::uint32_t u = mesh.triangles[t].n[i];
    if (is_side(u)) continue;
    const double before = std::max(mesh.excess[t], mesh.excess[u]);
    const double most = improvement_of(before);
    const double after = mesh.excess_after_flip(t, i, most);
    if (!(after < most)) continue;
    if (!best_edge || before - after > best_gain) {
      best_edge = i;
      best_gain = before - after;
    }
  }
  if (!best_edge) return false;
  const std::uint32_t u = mesh.triangles[t].n[*best_edge];
  if (!mesh.flip(t, *best_edge)) return false;
  --work.flips_left;
  work.look_around(t);
  work.look_around(u);
  return true;
}

}  // namespace cover
