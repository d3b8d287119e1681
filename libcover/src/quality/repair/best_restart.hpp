// Restarts of a tiny region, improved: the best of them.
#pragma once

#include "quality/effort/budget.hpp"
#include "quality/fault/merit.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// A mesh and its merit.
struct Restarted {
  MutableMesh mesh;
  Merit merit;
};

/// The best by `goal` of some restarts with one to three free vertices, improved with the largest
/// angle before all else; or `mesh`, if that is better. For tiny regions: there one restart in
/// three finds what no step from any other triangulation leads to.
///
/// REQUIRES: `before` is the merit of `mesh` by `goal`
/// ENSURES:  -cot of the largest angle is above `ceiling` only if the result is `mesh`
Restarted best_restart(const MutableMesh& mesh, const Merit& before, const Goal& goal,
                       double ceiling, Budget& budget);

}  // namespace cover
