// Cuts of a mesh, found again in its input.
#pragma once

#include <cstddef>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/triangle_soup.hpp>

namespace cover {

/// Cuts segments where `mesh`, made with cut segments, has a vertex on them, and orders points as
/// the vertices of the mesh are ordered; points that are no vertices keep their ids. Points and
/// segments that the mesh lacks are passed over: verify_cover() finds them.
///
/// Returns: the number of points added
/// Cost:    O(n log n)
std::size_t adopt_cuts(Pslg& pslg, RegionTable& table, const TriangleSoup& mesh);

}  // namespace cover
