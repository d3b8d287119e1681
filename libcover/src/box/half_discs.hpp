// Regions in which couplings leave no room for a vertex.
#pragma once

#include <span>
#include <vector>

#include <cover/point.hpp>

#include "cdt/cdt.hpp"

namespace cover {

/// Whether the open half discs over the free sides of a region cover its inside. Then a mesh with
/// any further vertex has a negative coupling on a free side, or on an inner edge (Theorem 1 of
/// docs/box_method.md: such a vertex sees that side under more than 90 degrees), and the
/// constrained Delaunay triangulation is the only mesh without one, up to flips of edges whose
/// coupling is 0.
///
/// False where that is not seen: for regions that are not convex (corners of 180 degrees are), that
/// have holes or points inside, or more than 24 sides; and where the discs touch by less than
/// 1e-10 of the size of the region, which is hundreds of times what rounding does here.
///
/// `is_free` tells by side: those that no vertex of the boundary encroaches.
///
/// Cost: O(sides^3), and O(sides) for most regions that are not covered
bool half_discs_cover(std::span<const Point> points, std::span<const IndexPair> sides,
                      const std::vector<bool>& is_free);

}  // namespace cover
