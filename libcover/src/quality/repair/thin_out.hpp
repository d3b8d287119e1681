// Fewer triangles where the targets are met.
#pragma once

#include <cstdint>

#include "quality/mutable/mutable_mesh.hpp"
#include "quality/parts/work_in_parts.hpp"

namespace cover {

/// What was done.
struct ThinOutResult {
  std::size_t removed = 0;        ///< vertices that are fewer
  std::uint64_t evaluations = 0;  ///< stars looked at
};

/// Removes free vertices, and replaces pairs of neighbouring free vertices by one, wherever the
/// triangles that come in their place meet the goal: they have no excess at all.
///
/// Cost: at most `budget` star evaluations; each vertex is looked at once, and again when its
///       star has changed. A large mesh is thinned in parts, and then along their borders.
ThinOutResult thin_out(MutableMesh& mesh, std::uint64_t budget, const Sharing& sharing = {});

}  // namespace cover
