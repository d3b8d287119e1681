// The constrained Delaunay triangulation of a region whose boundary nobody has vouched for.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cdt/cdt.hpp"

namespace cover {

/// Why sides do not bound a region with all points in or on it, and where.
struct BoundaryFault {
  std::string what;  ///< "the sides from (0, 0) to (1, 1) and from (0, 1) to (1, 0) cross"
  std::vector<Point> where;
  std::vector<std::uint32_t> points;  ///< the same places, as indices
};

/// What is wrong with a region: sides that cross, a point on a side, a side without a triangle on
/// its left or with one on its right, a point that no triangle has.
///
/// REQUIRES: `cdt` is what triangulate_domain() made of `points` and `sides`; `sides` in
///           lexicographic order
/// EXACT:    yes
/// Cost:     O(n log n), one pass
std::optional<BoundaryFault> find_fault(const CdtResult& cdt, std::span<const Point> points,
                                        std::span<const IndexPair> sides);

/// The constrained Delaunay triangulation of a region: every side has a triangle on its left, every
/// point is a corner.
///
/// Errors: throws an InternalFault if the sides do not bound a region
Triangulation triangulate_region(std::span<const Point> points, std::span<const IndexPair> sides);

}  // namespace cover
