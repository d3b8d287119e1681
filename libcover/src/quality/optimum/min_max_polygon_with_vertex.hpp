// The best triangulation of a small polygon with one vertex inside.
#pragma once

#include <cstdint>

#include "quality/mutable/cavity.hpp"

namespace cover {

/// Looks for a place for one new vertex in `cavity`, and triangulates the loop with it so that the
/// largest excess is least; not all corners of the loop need be joined with the vertex. Several
/// places are tried, because there are several local optima.
///
/// ENSURES: returns that excess, infinite if the loop is longer than `kPolygonLimit` or nothing
///          below `limit` was found. `evaluations` is raised by the time it took.
/// Cost:    O(k^4) for a loop of k edges
double min_max_polygon_with_vertex(const MutableMesh& mesh, const Cavity& cavity, double limit,
                                   Patch& patch, std::uint64_t& evaluations);

}  // namespace cover
