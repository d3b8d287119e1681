// Disks on all segments of a plane graph, shared by the regions on both sides.
#pragma once

#include <span>
#include <vector>

#include <cover/point.hpp>

#include "cdt/cdt.hpp"

namespace cover::disks {

/// A disk centred on a segment.
struct DiskOnSegment {
  Point centre;
  double radius = 0;
};

/// Disks that cover segments and points.
struct SegmentDisks {
  std::vector<double> radius;                     ///< of the disk around every point
  std::vector<std::vector<DiskOnSegment>> chain;  ///< by segment, from its first end to its second;
                                                  ///< without the disks around its ends
  /// Why it is not complete: more than `most` disks would be needed, or one that is too small.
  enum class Obstacle { none, too_many, too_small };
  Obstacle obstacle = Obstacle::none;
  std::size_t crowded = 0;  ///< then: the segment that was being covered, or nearest to a point
};

/// Covers every segment by disks centred on it. Consecutive disks touch, no others meet. No disk
/// is smaller than `smallest`, the size that coordinates can hold.
///
/// REQUIRES: points and segments meet only at points.
/// Cost:     one query per disk; the number of disks is the integral of 1 / distance to other
///           segments, and not bounded by the number of segments.
SegmentDisks cover_segments(std::span<const Point> points, std::span<const IndexPair> segments,
                            double smallest, std::size_t most);

}  // namespace cover::disks
