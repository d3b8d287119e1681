// The Delaunay triangulation of a small hole.
#pragma once

#include "quality/mutable/cavity.hpp"

namespace cover {

/// Triangulates the loop of `cavity` such that no corner of it lies in the circle of a triangle.
/// Where the mesh around is constrained Delaunay, and the hole comes from a vertex that is taken
/// away, it stays so.
///
/// ENSURES: returns the largest excess of the triangles; infinite, and `patch` is of no use, if
///          there is no such triangulation
/// EXACT:   yes, but for the excess
/// Cost:    O(k^2) for most loops of k edges, O(k^3) for others
/// Ref:     O. Devillers, On deletion in Delaunay triangulations (1999)
double delaunay_polygon(const MutableMesh& mesh, const Cavity& cavity, Patch& patch);

}  // namespace cover
