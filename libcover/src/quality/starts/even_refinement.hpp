// Chew's construction: all angles between 30 and 120 degrees, where the boundary is evenly spaced.
#pragma once

#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Inserts the circumcentres of triangles whose circumradius is above h, the least distance
/// between two vertices in sight of each other. If no side is longer than sqrt(3) h, the
/// circumcentres lie inside and at least h from every vertex, so that all edges end up between h
/// and 2 h and all angles between 30 and 120 degrees. Triangles that are the best there are for a
/// side whose angle is forced above the goal stay as they are.
///
/// REQUIRES: `mesh` is constrained Delaunay, with its goal set
/// ENSURES:  `mesh` is constrained Delaunay, its excesses measured, its numbers arranged; or it is
///           unchanged, and false is returned: a side is longer, or h so short beside the region
///           that the vertices would be many
/// Cost:     as plain Delaunay refinement, O(vertices) in practice
/// Ref:      L. P. Chew, Guaranteed-quality triangular meshes, Cornell TR 89-983 (1989)
bool refine_evenly(MutableMesh& mesh);

}  // namespace cover
