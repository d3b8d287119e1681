// Constrained Delaunay triangulation (CGAL inside, plain arrays outside).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/team.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// A pair of point indices.
using IndexPair = std::array<std::uint32_t, 2>;

/// Why points and segments are no PSLG.
struct CdtConflict {
  enum class Kind {
    duplicate_point,   ///< points `first` and `second` have the same coordinates
    point_on_segment,  ///< point `first` lies inside segment `second`
    crossing,          ///< segments `first` and `second` cross in their insides
  };
  Kind kind = Kind::crossing;
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

/// A triangulation, or the conflict that prevents it.
struct CdtResult {
  Triangulation triangulation;
  std::vector<CdtConflict> conflicts;  ///< empty: the triangulation is complete
};

/// Constrained Delaunay triangulation of the convex hull of `points`; `segments` are its locked
/// edges (a pair may occur twice, in either direction).
///
/// EXACT:   topology is decided by exact predicates. Where more than three points are cocircular
///          the result depends on the order of `points`, on nothing else.
/// Cost:    O(n log n) expected; many points by the whole team
CdtResult triangulate_hull(std::span<const Point> points, std::span<const IndexPair> segments,
                           const Team& team = {});

/// Constrained Delaunay triangulation of the domain on the left of the directed `sides`, which are
/// its locked edges. A slit is given in both directions. Points outside the domain are ignored.
///
/// The sides bound a domain if, around every vertex, domain and void alternate properly. If they do
/// not, the result is a set of triangles in the convex hull for which some side has no triangle on
/// its left, or one on its right.
///
/// Of sides that conflict, up to `most_conflicts` are told: each of those that could not be
/// inserted, with the first one that is in its way.
CdtResult triangulate_domain(std::span<const Point> points, std::span<const IndexPair> sides,
                             std::size_t most_conflicts = 1);

}  // namespace cover
