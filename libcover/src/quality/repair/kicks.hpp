// Kicks, each followed by improvement, tried in excerpts.
#pragma once

#include "quality/effort/budget.hpp"
#include "quality/fault/merit.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Improves for a stricter goal first, then for the one set: what ends just short of a goal can be
/// led past it, as where right angles at a side would have to be met exactly.
void improve_with_slack(MutableMesh& mesh, Budget& budget);

/// Kicks triangle 0 of `mesh` in every way, as below, until one makes it better by `goal`.
bool kick_and_improve(MutableMesh& mesh, const Goal& goal, Budget& budget);

/// Tries, for every triangle with a larger angle than the goal allows: a vertex in its middle or on
/// one of its edges, a flip, the removal of a vertex; and improves what comes of it, for the goal
/// that `mesh` has set. Keeps what is better by `goal`, and goes on from there.
///
/// REQUIRES: `mesh` is improved, `before` is its merit by `goal`
/// ENSURES:  returns the merit afterwards, which is no worse: no more triangles are above the goal,
///           and the largest angle has grown at most among those that count as alike (merit.hpp)
/// Cost:     an attempt looks at some dozens of triangles around, however many there are
Merit improve_by_kicks(MutableMesh& mesh, const Goal& goal, const Merit& before, Budget& budget);

}  // namespace cover
