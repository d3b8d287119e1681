// Straight walks through a triangulation.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cdt/sides.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// Where a straight walk ended.
struct Walk {
  bool arrived = false;
  EdgeRef at;  ///< arrived: a triangle that contains the target; else the edge that stopped it
  std::size_t passed = 0;  ///< triangles
};

/// Walks from `from`, a point of triangle `start`, straight towards `to` until a triangle contains
/// it (with its boundary) or a locked edge or the outside is in the way.
///
/// EXACT: which edges are crossed, for the coordinates as given; `from` may lie outside `start` by
///        rounding.
/// Cost:  O(triangles passed)
Walk walk_straight(const Triangulation& cdt, std::uint32_t start, Point from, Point to);

}  // namespace cover
