// A region or an excerpt triangulated anew, from other free vertices.
#pragma once

#include <cstdint>
#include <optional>

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

}  // namespace cover
