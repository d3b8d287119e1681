// All regions as one mesh, whose cuts may be others, and back.
#pragma once

#include <cstdint>
#include <vector>

#include "cuts/unite_pieces.hpp"
#include "cuts/work.hpp"
#include "mend/conforming_mesh.hpp"

namespace cover {

/// The meshes of all regions in one. `uncut` is the PSLG of `work` before its segments were cut,
/// and `united` what unite_pieces() said of it. Chords of arcs stay whole.
ConformingMesh join(const Work& work, const Pslg& uncut, const United& united);

/// Points, lines and triangles in the order of their coordinates, which does not depend on that of
/// the input. Returns the old numbers of the points.
std::vector<std::uint32_t> sort_by_place(ConformingMesh& mesh);

/// Gives each point another number, `number`, by the one it has.
///
/// REQUIRES: `number` is a permutation
void renumber(const std::vector<std::uint32_t>& number, ConformingMesh& mesh);

/// Puts what has come of the mesh into `work`, whose segments are whole. `old` are the numbers
/// that its fixed points have in the PSLG, in their order in `mesh`.
void separate(const ConformingMesh& mesh, const std::vector<std::uint32_t>& old, Work& work);

}  // namespace cover
