// Triangulations without obtuse angles, with fewer vertices.
#pragma once

#include <cstdint>

#include "mend/mend_mesh.hpp"
#include "mend/mesh_with_undo.hpp"

namespace cover {

/// How many places are tried to thin a mesh out.
struct ThinEffort {
  std::uint64_t places_per_vertex = 0;  ///< for every vertex that may go
  std::uint64_t places_at_most = 0;
  MendEffort mending{};  ///< besides
};

/// Takes vertices away, merges several into fewer and moves them, so that no more triangles are
/// bad; adds some where that makes bad triangles fewer, or those that are worse than any may be
/// (mend_beyond_worst). Points of the input stay.
///
/// ENSURES: the same mesh for the same input, whatever the machine
/// Cost:    as `effort` says
/// Ref:     libcover/docs/cutting_segments.md, "Fewer vertices"
BadTriangles thin_mesh(MeshWithUndo& mesh, const ThinEffort& effort);

}  // namespace cover
