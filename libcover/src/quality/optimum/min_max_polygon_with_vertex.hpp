// The best triangulation of a small polygon with one vertex inside.
#pragma once

#include <cstdint>

#include "quality/mutable/cavity.hpp"

namespace cover {

/// What came of looking for a vertex.
struct PlacedVertex {
  double worst = kInverted;       ///< the largest excess
  std::uint64_t evaluations = 0;  ///< the time it took, in star evaluations
};

/// Looks for a place for one new vertex in `cavity`, and triangulates the loop with it so that the
/// largest excess is least; not all corners of the loop need be joined with the vertex. Several
/// places are tried, because there are several local optima.
///
/// ENSURES: the excess is infinite if the loop is longer than `kPolygonLimit` or nothing below
///          `most` was found; else `patch` has the triangles.
/// Cost:    O(k^4) for a loop of k edges
PlacedVertex min_max_polygon_with_vertex(const MutableMesh& mesh, const Cavity& cavity, double most,
                                         Patch& patch);

}  // namespace cover
