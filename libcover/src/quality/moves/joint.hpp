// Several neighbouring vertices moved at once.
// Mends: triangles that tie, so that no vertex alone can leave its place.
#pragma once

#include <cstdint>

#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Moves the free vertices nearest to triangle `t`, up to six, so that the worst excess of the
/// triangles around them is as low as can be. Where triangles tie that share these vertices, no
/// move of a single one makes the worst better.
///
/// ENSURES: false, and nothing has changed, if that is not lower than before. No triangle is turned
///          over. `evaluations` is raised by the time it took, in star evaluations.
bool place_jointly(MutableMesh& mesh, std::uint32_t t, std::uint64_t& evaluations);

}  // namespace cover
