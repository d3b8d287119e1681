// The best triangulation of a small polygon.
#pragma once

#include "quality/mutable/cavity.hpp"

namespace cover {

/// Triangulates the loop of `cavity` without a new vertex so that the largest excess is least.
///
/// ENSURES: returns that excess, infinite if the loop is longer than `kPolygonLimit`.
/// Cost:    O(k^3) for a loop of k edges, by dynamic programming.
/// Ref:     G. Klincsek, Minimal triangulations of polygonal domains (1980), with max for sum
double min_max_polygon(const MutableMesh& mesh, const Cavity& cavity, double most, Patch& patch);

inline constexpr int kPolygonLimit = 10;

}  // namespace cover
