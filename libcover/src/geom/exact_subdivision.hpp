// Where segments cut each other, exactly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// A segment between two different points.
struct PlainSegment {
  Point a;
  Point b;
};

/// A maximal piece of segments between two places where anything ends, touches or crosses.
struct SubSegment {
  Point left;  ///< the lexicographically smaller end, rounded to the nearest doubles
  Point right;
  std::vector<std::uint32_t> parents;  ///< the segments that it is a piece of, ascending
};

/// Cuts segments at all their common points.
///
/// EXACT: what meets where is decided exactly and intersections are computed exactly; only the
///        coordinates given back are rounded, so that pieces may cross or degenerate by rounding.
/// Cost:  O((n + k) log n) for k common points: a plane sweep, whatever the shape of the segments.
std::vector<SubSegment> subdivide(std::span<const PlainSegment> segments);

}  // namespace cover
