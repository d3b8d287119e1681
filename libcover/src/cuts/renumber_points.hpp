// Another order for the points of a PSLG.
#pragma once

#include <span>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>

namespace cover {

/// Gives every point the id `new_ids[old id]`.
///
/// REQUIRES: `new_ids` is a permutation of the ids
/// ENSURES:  `pslg` and `table` are the same but for the order of points
/// Cost:     O(n)
void renumber_points(Pslg& pslg, RegionTable& table, std::span<const VertexId> new_ids);

}  // namespace cover
