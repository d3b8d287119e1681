// A region or an excerpt triangulated anew, from other free vertices.
#pragma once

#include <cstdint>
#include <optional>

#include "quality/effort/budget.hpp"
#include "quality/fault/merit.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Star evaluations in the time of a restart.
inline constexpr std::uint64_t kRestartCost = 300;

/// The constrained Delaunay triangulation of the fixed vertices of `mesh` and `count` free ones at
/// random places inside, the same ones for the same `number`. The sides are those of `mesh`, and
/// so is the goal.
///
/// ENSURES: nothing if rounding left a place or a side outside of the triangulation
/// Cost:     O(n log n) for n vertices: a constrained Delaunay triangulation
std::optional<MutableMesh> restart(const MutableMesh& mesh, std::size_t count,
                                   std::uint32_t number);

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
