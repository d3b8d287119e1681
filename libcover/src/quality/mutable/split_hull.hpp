// Sides of the convex hull that a triangulation has split.
#pragma once

#include <cstdint>
#include <vector>

#include "cdt/sides.hpp"
#include "cdt/triangulation.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// Where the sides of a region lie in a triangulation that has split sides of the hull.
struct SplitSides {
  std::vector<EdgeRef> at;  ///< by side: the edge, or its first piece; then all other pieces
  std::vector<std::uint32_t> split;  ///< the sides that are split
  std::uint32_t fixed = 0;           ///< vertices on the boundary, numbered first
};

/// Finds the sides of `boundary` in `triangles`, over its points and Steiner vertices. Steiner
/// vertices on the hull are renumbered to follow the points of the boundary, since nothing may move
/// them.
///
/// REQUIRES: all edges of `triangles` are locked (with_neighbours)
SplitSides locate_split_sides(Triangulation& triangles, const RegionBoundary& boundary);

}  // namespace cover
