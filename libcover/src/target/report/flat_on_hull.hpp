// Triangles that are there by rounding alone, along the hull.
#pragma once

#include <span>
#include <vector>

#include "geom/topology/half_edges.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// The triangles of a region's mesh but for those between a side of the hull and points that could
/// lie on it by rounding: nobody can tell these from vertices that split the side.
///
/// Cost: O(n log n)
std::vector<IndexTriple> without_flat_on_hull(const RegionBoundary& boundary,
                                              std::span<const Point> points,
                                              std::span<const IndexTriple> triangles);

}  // namespace cover
