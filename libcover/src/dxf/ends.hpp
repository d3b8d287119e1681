// Ends of curves that are the same point but for rounding.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// Ends of lines as the file gives them, and of arcs as computed from centre, radius and angles,
/// which miss those by the rounding of these numbers: by 2^-40 of the drawing's size at most, or
/// they are different points.
class CurveEnds {
 public:
  /// Points of the drawing, with both signs, have no coordinate larger than `size`.
  explicit CurveEnds(double size);

  /// An end as it is; those that are added first count.
  void add(Point p);
  /// The point that was added first and is the same, or `p` itself.
  [[nodiscard]] Point same(Point p) const;

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  [[nodiscard]] Cell cell_of(Point p) const;
  [[nodiscard]] bool has_cell(Point p) const {
    return reach_ > 0 && std::abs(p.x) <= farthest_ && std::abs(p.y) <= farthest_;
  }

  double reach_;
  double farthest_;               ///< beyond, cells would have too large numbers
  std::map<Cell, Point> points_;  ///< one per cell: cells are as small as the reach
};

}  // namespace cover
