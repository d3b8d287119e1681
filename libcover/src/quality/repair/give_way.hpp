// Vertices that would make couplings of sides negative, taken away.
#pragma once

#include <cstddef>

#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Takes away the free vertices that see a side under a larger angle than its coupling allows, and
/// what comes to do so by that, in the way of Delaunay triangulations. Sides that no vertex of the
/// boundary encroaches end without negative couplings, but where a star is too large to be filled.
///
/// REQUIRES: the mesh is Delaunay; its goal counts couplings
/// ENSURES:  the mesh is Delaunay
/// Cost:     O(n), and the stars of what is taken away
/// Returns how many vertices were taken away.
std::size_t give_way_to_sides(MutableMesh& mesh);

}  // namespace cover
