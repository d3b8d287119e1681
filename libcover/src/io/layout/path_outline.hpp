// The area of a path: a middle line with a width.
#pragma once

#include <vector>

#include <cover/point.hpp>

namespace cover {

/// A path to be drawn.
struct WidePath {
  std::vector<Point> line;  ///< two points or more, neighbours differ
  double half_width = 0;    ///< > 0
  double begin = 0;         ///< how much longer it is at its first point
  double end = 0;           ///< and at its last one
  bool round = false;       ///< half a disk at both ends
  double step = 5;          ///< what a chord of those may turn by, in degrees
};

/// Polygons that cover the path: its outline, where that does not cross itself, else one for each
/// piece of it and for each corner. Corners are mitred, and cut off where they turn by more than
/// 120 degrees. Paths along the axes keep their digits.
///
/// Cost: O(n^2) up to 256 points, O(n) above
std::vector<std::vector<Point>> path_polygons(WidePath path);

}  // namespace cover
