// Out of a local optimum: a step that makes a triangulation worse first. Mends: nothing by itself;
// what no step that only helps can reach, by the improvement that follows.
#pragma once

#include <cstdint>

#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Kinds of kicks: a vertex in the middle, on one of three edges, three flips, three removals.
inline constexpr int kKinds = 10;

/// Changes `mesh` around triangle `t`, for better or worse. False if that kind does not apply.
bool kick(MutableMesh& mesh, std::uint32_t t, int kind);

}  // namespace cover
