// Cuts segments of a clean PSLG at points on them, where their regions are known already.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>

#include "cdt/cdt.hpp"

namespace cover {

/// New points on a segment, from its end a to its end b.
struct SegmentCut {
  SegmentId segment;
  std::vector<Point> points;
};

/// A new point on a segment.
struct PointOnSegment {
  SegmentId segment;
  Point point;
};

/// The same points segment by segment, and along each from its end a on.
struct PointsAlong {
  std::vector<std::uint32_t> order;  ///< of the points
  std::vector<SegmentCut> cuts;
};
/// Cost: O(n log n)
PointsAlong along_segments(const Pslg& pslg, std::span<const PointOnSegment> points);

/// Replaces each cut segment by its pieces, which keep its marker, name, id, circle, sides and
/// interface. Pieces of periodic segments are pairs as long as both were cut alike, see
/// with_images(); else neither is periodic any more.
///
/// Pieces of a segment are consecutive. New points come after all others, cut by cut.
/// REQUIRES: `cuts` in the order of segments, each segment at most once.
/// ENSURES:  faces and regions are the same, up to rounding of the new points; where these lie
///           beside a chord of an arc, areas and lengths follow.
/// Cost:     O(n).
void cut_segments(Pslg& pslg, RegionTable& table, std::span<const SegmentCut> cuts);

/// The constrained Delaunay triangulation of all of it, the void too. Its conflicts are what meets
/// where it should not: rounded cuts may have closed a gap.
/// EXACT: yes
/// Cost:  O(n log n)
CdtResult triangulate_whole(const Pslg& pslg);

/// The ends of segments in the void, and points there, that lie in a region: a cut beside them,
/// rounded, passed to their other side, and nothing crosses where they hang on the cut segment.
///
/// REQUIRES: `whole` is triangulate_whole(pslg), without conflicts
/// EXACT:    yes
/// Cost:     O(n log n)
std::vector<VertexId> void_in_regions(const Pslg& pslg, const RegionTable& table,
                                      const Triangulation& whole);

/// Each region is sound by itself; what lies on both sides of the void is looked at here, where
/// there are more points than the `uncut_points` that there were before.
///
/// Errors: meshing_incomplete, with a place, where cut segments meet, or pass what is in the void
/// Cost:   that of triangulate_whole()
Status check_cuts(const Pslg& pslg, const RegionTable& table, std::size_t uncut_points);

}  // namespace cover
