// Boxes with sides along the axes.
#pragma once

#include <algorithm>
#include <span>

#include <cover/point.hpp>

#include "base/numbers.hpp"
#include "geom/vector.hpp"

namespace cover {

/// The smallest box around what was added; empty at first.
struct Box {
  Point low{kInfinity, kInfinity};
  Point high{-kInfinity, -kInfinity};

  void add(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  /// The smallest box around both.
  void include(const Box& other) {
    if (other.is_empty()) return;
    add(other.low);
    add(other.high);
  }
  [[nodiscard]] bool is_empty() const { return !(low.x <= high.x); }
  [[nodiscard]] double width() const { return high.x - low.x; }
  [[nodiscard]] double height() const { return high.y - low.y; }
  /// The longer side; minus infinity if the box is empty.
  [[nodiscard]] double extent() const { return std::max(width(), height()); }
  /// No two points of the box are farther apart.
  [[nodiscard]] double diagonal() const { return is_empty() ? 0 : length(high - low); }
  /// Its sides belong to it.
  [[nodiscard]] bool holds(Point p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
  }
  /// Whether they have a point in common; an empty box meets none.
  [[nodiscard]] bool meets(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y;
  }
};

/// The smallest box around points.
inline Box box_of(std::span<const Point> points) {
  Box box;
  for (const Point& p : points) box.add(p);
  return box;
}

}  // namespace cover
