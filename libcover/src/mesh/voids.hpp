// What a mesh encloses and no triangle fills.
#pragma once

#include <vector>

#include <cover/mesh.hpp>
#include <cover/point.hpp>
#include <cover/report.hpp>

namespace cover {

/// A point inside each void that a mesh encloses: also of several that meet in a point, and of one
/// with an island in it. Edges that lie on one another, as those of a crack or of parts with points
/// of their own, enclose nothing. `notes` tells of what no point is found for.
///
/// EXACT: yes
/// Cost:  O(n log n) for the edges with one triangle, O(n) for the others
std::vector<Point> places_in_voids(const Mesh& mesh, std::vector<Note>& notes);

}  // namespace cover
