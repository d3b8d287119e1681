// Improvement, one vertex at a time and then several at once, in turn.
#pragma once

#include <algorithm>
#include <cstdint>

#include "quality/effort/budget.hpp"
#include "quality/moves/joint.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "quality/repair/improve.hpp"

namespace cover {

/// The triangle with the largest excess.
inline std::uint32_t worst_of(const MutableMesh& mesh) {
  return static_cast<std::uint32_t>(std::max_element(mesh.excess.begin(), mesh.excess.end()) -
                                    mesh.excess.begin());
}

/// Moves several vertices at once where `mesh` is worst, improves it again, and so on a few times,
/// until `is_enough()`.
///
/// ENSURES: returns what `is_enough()` says in the end
template <class IsEnough>
bool improve_jointly(MutableMesh& mesh, Budget& budget, IsEnough is_enough) {
  constexpr int kTimes = 3;
  if (is_enough()) return true;
  for (int k = 0; k < kTimes && !budget.is_used_up(); ++k) {
    const std::uint32_t worst = worst_of(mesh);
    if (!(mesh.excess[worst] > kSameCot)) return false;
    const JointMove move = place_jointly(mesh, worst);
    budget.spend(move.evaluations);
    if (!move.has_moved) return false;
    if (is_enough()) return true;
    budget.spend(improve(mesh, budget.left).evaluations);
    if (is_enough()) return true;
  }
  return false;
}

}  // namespace cover
