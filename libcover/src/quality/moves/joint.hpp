// Several neighbouring vertices moved at once.
// Mends: triangles that tie, so that no vertex alone can leave its place.
#pragma once

#include <cstdint>

#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// What came of it.
struct JointMove {
  bool has_moved = false;
  std::uint64_t evaluations = 0;  ///< the time it took, in star evaluations
};

/// Moves the free vertices nearest to triangle `t`, up to six, so that the worst excess of the
/// triangles around them is as low as can be. Where triangles tie that share these vertices, no
/// move of a single one makes the worst better.
///
/// ENSURES: nothing has changed if that is not lower than before. No triangle is turned over.
JointMove place_jointly(MutableMesh& mesh, std::uint32_t t);

}  // namespace cover
