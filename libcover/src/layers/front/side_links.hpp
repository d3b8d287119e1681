// The sides of a region one after the other.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/vector.hpp"
#include "region/region_boundary.hpp"

namespace cover::layers {

/// By side: the one that follows it around the region, which is the first one clockwise from it
/// around its end.
///
/// EXACT: yes
/// Cost:  O(n log n), for the few sides that usually leave a vertex
std::vector<std::uint32_t> next_sides(const RegionBoundary& boundary);

/// The unit normal of the line from a to b that points to its left.
Vector unit_normal(Point a, Point b);

}  // namespace cover::layers
