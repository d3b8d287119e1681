// The constrained Delaunay triangulation of a region whose boundary nobody has vouched for.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/team.hpp"
#include "cdt/cdt.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {

/// Why sides do not bound a region with all points in or on it, or triangles do not fill it, and
/// where.
struct Flaw {
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
std::optional<Flaw> find_flaw(const CdtResult& cdt, std::span<const Point> points,
                              std::span<const IndexPair> sides);

/// Regions of no more points than the one and from the other on are triangulated in order: in small
/// ones all moves are tried in any case, and large ones average over many places.
inline constexpr std::size_t kSmallRegion = 16, kLargeRegion = 1'000;

/// Sorts triangles by their corners, the lowest corner of each first.
///
/// REQUIRES: corners below `points`
/// Cost:     O(points + n), for the few triangles that a point usually has
void put_in_order(std::size_t points, std::vector<IndexTriple>& triangles, const Team& team = {});

/// The constrained Delaunay triangulation of a region: every side has a triangle on its left, every
/// point is a corner. Its triangles are in order (put_in_order()), which does not tell who has made
/// them.
///
/// `known` are its triangles as somebody else has found them, in that order, or any others, or
/// none. They are taken if they are the only ones that there can be: then nothing depends on them
/// but the time. That is so if they fill the sides, each is counter-clockwise, and no inner edge
/// has its corners on or within one circle.
///
/// REQUIRES: no two of `known` have the same directed edge
/// EXACT:    yes
/// Errors:   throws an InternalFault if the sides do not bound a region
Triangulation triangulate_in_order(std::span<const Point> points, std::span<const IndexPair> sides,
                                   std::span<const IndexTriple> known = {}, const Team& team = {});

/// The same, but the triangles of regions that are neither small nor large come as they are made,
/// and `known` is not looked at: triangles that were inserted one after the other are a better
/// start for moves. In order, 40 of 40,000 wavy squares of 61 points miss 100 degrees instead of
/// 31, for 8 % fewer instructions; one of the 900 of the benchmark ends at 105.4 instead of 99.998.
///
/// REQUIRES, EXACT, Errors: as above
Triangulation triangulate_region(std::span<const Point> points, std::span<const IndexPair> sides,
                                 std::span<const IndexTriple> known = {}, const Team& team = {});

}  // namespace cover
