// All regions as a joined mesh, whose cuts may be others, and back.
#pragma once

#include <cstdint>
#include <vector>

#include "cuts/unite_pieces.hpp"
#include "cuts/work.hpp"
#include "mend/joined_mesh.hpp"

namespace cover {

/// The meshes of all regions in one. `uncut` is the PSLG of `work` before its segments were cut,
/// and `united` what unite_pieces() said of it. Chords of arcs stay whole.
JoinedMesh join_regions(const Work& work, const Pslg& uncut, const United& united);

/// Points, lines and triangles in the order of their coordinates, which does not depend on that of
/// the input. Returns the old numbers of the points.
std::vector<std::uint32_t> sort_by_place(JoinedMesh& mesh);

/// Gives each point another number, `number`, by the one it has.
///
/// REQUIRES: `number` is a permutation
void renumber(const std::vector<std::uint32_t>& number, JoinedMesh& mesh);

/// Puts what has come of the mesh into `work`, whose segments are whole. `old` are the numbers
/// that its fixed points have in the PSLG, in their order in `mesh`.
void separate(const JoinedMesh& mesh, const std::vector<std::uint32_t>& old, Work& work);

}  // namespace cover
