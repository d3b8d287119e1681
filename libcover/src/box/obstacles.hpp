// What stands in the diametral disk of a segment, seen from one of its regions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/point.hpp>

#include "base/containers/stamped_set.hpp"
#include "cdt/sides.hpp"

namespace cover {

/// A vertex in the diametral disk of a segment, in lengths of the segment from its end a.
struct Obstacle {
  double along = 0;   ///< where the perpendicular from the vertex meets the segment; in (0, 1)
  double height = 0;  ///< positive
  Point at;
};

/// Rounding error of `along` and `height`, at most.
inline constexpr double kObstacleRounding = 0x1p-47;

/// Finds the obstacles of the sides of one region.
class ObstacleFinder {
 public:
  /// REQUIRES: `cdt` outlives this object
  explicit ObstacleFinder(const Triangulation& cdt);

  /// The vertices in the open diametral disk of `side` that see the foot of their perpendicular on
  /// it, from its start on; only some of them where the work for all sides together would be too
  /// much.
  ///
  /// Cost: the number of triangles in the disk; over all calls at most a constant for each triangle
  [[nodiscard]] std::vector<Obstacle> obstacles(EdgeRef side);

 private:
  [[nodiscard]] bool sees_foot(std::uint32_t start, Point foot, Point p);

  const Triangulation& cdt_;
  StampedSet seen_;  ///< triangles, by the present call
  std::vector<std::uint32_t> stack_;
  std::uint64_t budget_;  ///< triangles that may still be looked at
};

/// The same obstacles, seen from the other end of the segment and its other side.
std::vector<Obstacle> turned_round(std::vector<Obstacle> obstacles);

/// All obstacles of a segment, from its end a on.
std::vector<Obstacle> merged(std::vector<Obstacle> one, std::span<const Obstacle> other);

}  // namespace cover
