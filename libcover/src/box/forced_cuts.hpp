// What the input forces on the box method: encroached sides, and the least number of cuts.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <cover/ids.hpp>
#include <cover/point.hpp>

#include "box/obstacles.hpp"
#include "cdt/triangulation.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// An encroached side of a region.
struct EncroachedSegment {
  SegmentId segment;                ///< or kHullSide
  Point a, b;                       ///< the side, with the region on its left
  Point by;                         ///< the vertex that sees it under the largest angle
  std::vector<Obstacle> obstacles;  ///< from the lesser end on, so that both sides agree
};

/// The encroached sides of a region, with all that stands in their disks.
///
/// REQUIRES: `cdt` is the constrained Delaunay triangulation of the region
/// Cost:     see ObstacleFinder
std::vector<EncroachedSegment> encroached_segments(const RegionBoundary& boundary,
                                                   const Triangulation& cdt);

/// Segments and cuts.
struct ForcedCuts {
  std::size_t segments = 0;  ///< that are encroached on at least one side
  std::size_t least = 0;     ///< cuts on them, at least
};

/// From the encroached sides of all regions; those of a segment are taken together.
ForcedCuts forced_cuts(std::span<const std::vector<EncroachedSegment>> regions);

}  // namespace cover
