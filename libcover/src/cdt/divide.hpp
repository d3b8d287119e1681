// A constrained Delaunay triangulation of very many points, by several threads.
#pragma once

#include <optional>
#include <span>

#include "base/team.hpp"
#include "cdt/cdt.hpp"

namespace cover {

/// What triangulate_hull() makes, of points and segments that are a PSLG: a third of the memory,
/// and several threads. Triangles that are near each other in the plane are so in the list.
///
/// Returns: nothing if points or segments are in conflict, or all points are on one line, or
///          segments that are not in the Delaunay triangulation cross very many of its edges:
///          triangulate_hull() tells of the first and bears the others
/// EXACT:   topology is decided by exact predicates. The result depends on the order of points and
///          segments, not on the team
/// Cost:    O(n log n), and for each segment the edges of the Delaunay triangulation that it
///          crosses
/// Ref:     guibas_stolfi_1985_primitives, sloan_1993_constrained
std::optional<Triangulation> triangulate_divided(std::span<const Point> points,
                                                 std::span<const IndexPair> segments,
                                                 const Team& team);

}  // namespace cover
