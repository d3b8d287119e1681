// Clefts: narrow parts of regions between two long segments.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>

#include "region/region_boundary.hpp"

namespace cover {

/// A part of a region between two segments, its walls, that are far longer than they are apart,
/// while nothing else is as near to them.
struct Cleft {
  /// One of its ends: across from wall to wall.
  struct End {
    std::array<VertexId, 2> corner;    ///< of the first wall and of the other
    std::optional<SegmentId> segment;  ///< between them, if there is one
    RegionId beyond;                   ///< what lies there; kVoid: nothing
    double slant = 0;                  ///< how far from a right angle it is to a wall, as a sine
    double room = 0;                   ///< to the next segments
  };

  RegionId region;
  std::array<SegmentId, 2> wall;
  std::array<RegionId, 2> behind;  ///< each wall: kVoid for one of them at most
  std::array<End, 2> end;          ///< from the first one on the cleft lies right of the first wall
};

/// The clefts of segments that are not cut. No vertex is of two clefts. Which of its walls comes
/// first depends on places alone.
///
/// REQUIRES: `boundaries` are split_regions() of the others
/// Cost:     O(n log n)
std::vector<Cleft> find_clefts(const Pslg& pslg, const RegionTable& table,
                               std::span<const RegionBoundary> boundaries);

}  // namespace cover
