// Out of local optima: steps that make a triangulation worse first.
#pragma once

#include "quality/merit.hpp"
#include "quality/mutable_mesh.hpp"
#include "quality/optimise.hpp"

namespace cover {

/// Kinds of kicks: a vertex in the middle, on one of three edges, three flips, three removals.
inline constexpr int kKinds = 10;

/// Changes `mesh` around triangle `t`, for better or worse. False if that kind does not apply.
bool kick(MutableMesh& mesh, std::uint32_t t, int kind);

/// Improves for a stricter goal first, then for the one set: what ends just short of a goal can be
/// led past it, as where right angles at a side would have to be met exactly.
void improve_with_slack(MutableMesh& mesh, Budget& budget);

/// Kicks triangle 0 of `mesh` in every way, as below, until one makes it better by `goal`.
bool kick_and_improve(MutableMesh& mesh, const Goal& goal, Budget& budget);

/// Tries, for every triangle with a larger angle than the goal allows: a vertex in its middle or on
/// one of its edges, a flip, the removal of a vertex; and improves what comes of it, for the goal
/// that `mesh` has set. Keeps what is better by `goal`, and goes on from there.
///
/// REQUIRES: `mesh` is improved, `merit` is its merit by `goal`
/// ENSURES:  neither the largest angle nor the number of triangles above the goal has grown
/// Cost:     an attempt looks at some dozens of triangles around, however many there are
void improve_by_kicks(MutableMesh& mesh, const Goal& goal, Merit& merit, Budget& budget);

}  // namespace cover
