// Segments that face each other across strips narrower than the edges wished along them.
#pragma once

#include <span>
#include <vector>

#include <cover/pslg.hpp>

#include "region/region_boundary.hpp"
#include "sizes/segment_sizes.hpp"
#include "target/angle_limit.hpp"

namespace cover {

/// What may face a segment across a narrow strip.
struct Facing {
  std::vector<Point> vertices;
  std::vector<SegmentId> segments;
};

/// Adds what may face the sides of a region in it: vertices that are neighbours of a side's ends in
/// the constrained Delaunay triangulation, as a chain of vertices along a long side is, and
/// segments at the apex of its triangle. Nothing where very many sides meet: what lies between
/// those is a wedge and no strip.
///
/// REQUIRES: `cdt` is that of `boundary`, `limit` what angle_limit() says of it; `facing` has a
///           place for every segment
/// Cost:     linear
void look_across(const RegionBoundary& boundary, const Triangulation& cdt, const AngleLimit& limit,
                 std::vector<Facing>& facing);

/// The feet on the segment `from`-`to` of the vertices that face it across a strip no wider
/// than half of the edge length wished there, in their order.
///
/// REQUIRES: `sizes` are of that segment; `apexes` are those of the triangles on both sides
std::vector<Point> feet_across(Point from, Point to, const Facing& facing,
                               const SegmentSizes& sizes, std::span<const Point> apexes);

/// Whether the segment `facing` has both ends near the line through `a` and `b`, across a strip
/// that is narrow for edges of length `wished`.
bool lies_across(Point a, Point b, Point facing_a, Point facing_b, double wished);

}  // namespace cover
