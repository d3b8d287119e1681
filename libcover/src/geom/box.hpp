// Boxes with sides along the axes.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include <cover/point.hpp>

namespace cover {

/// The smallest box around what was added; empty at first.
struct Box {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  [[nodiscard]] double width() const { return high.x - low.x; }
  [[nodiscard]] double height() const { return high.y - low.y; }
  /// The longer side; minus infinity if the box is empty.
  [[nodiscard]] double extent() const { return std::max(width(), height()); }
};

/// The smallest box around points.
inline Box box_of(std::span<const Point> points) {
  Box box;
  for (const Point& p : points) box.add(p);
  return box;
}

}  // namespace cover
