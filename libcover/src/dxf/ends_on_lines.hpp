// Ends of curves that lie on straight lines of others but for rounding.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/input.hpp>
#include <cover/point.hpp>

namespace cover {

/// A line that goes through an end since it missed it by so little.
struct EndOnLine {
  Point end;
  long line = 0;  ///< InputSegment::id
  Point a, b;     ///< from where to where it went straight
  double away = 0;
};

/// Lets straight segments of `input` go through ends of others that are not on them, but no farther
/// away than `reach`. Inner points of arcs are no ends. Returns which; cleaning finds ends that are
/// on segments.
/// Cost: O(n log n) where few ends are near one line
std::vector<EndOnLine> bend_to_ends(Input& input, double reach);

}  // namespace cover
