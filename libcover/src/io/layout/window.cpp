// Tested by tests/unit/io/layout/window_test.cpp.
#include "io/layout/window.hpp"

#include <array>

namespace cover {
namespace {

/// One side of a window: what is kept has its coordinate on the right side of `limit`.
struct Side {
  double Point::*coordinate;
  double Point::*other;
  double limit;
  bool keep_above;

  [[nodiscard]] bool keeps(Point p) const {
    return keep_above ? p.*coordinate >= limit : p.*coordinate <= limit;
  }
  /// Where a line crosses the side; the same from both ends.
  [[nodiscard]] Point crossing(Point a, Point b) const {
    if (b < a) std::swap(a, b);
    const double t = (limit - a.*coordinate) / (b.*coordinate - a.*coordinate);
    Point p;
    p.*coordinate = limit;
    p.*other = a.*other == b.*other ? a.*other : a.*other + t * (b.*other - a.*other);
    return p;
  }
};

std::array<Side, 4> sides_of(const Window& w) {
  return {Side{&Point::x, &Point::y, w.low.x, true}, Side{&Point::x, &Point::y, w.high.x, false},
          Side{&Point::y, &Point::x, w.low.y, true}, Side{&Point::y, &Point::x, w.high.y, false}};
}

}  // namespace

std::vector<Point> clip_polygon(std::vector<Point> polygon, const Window& window) {
  std::vector<Point> kept;
  for (const Side& side : sides_of(window)) {
    kept.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      if (side.keeps(a)) kept.push_back(a);
      if (side.keeps(a) != side.keeps(b)) kept.push_back(side.crossing(a, b));
    }
    polygon.swap(kept);
  }
  // What only touches the window has all its points on one side of it.
  kept.clear();
  for (const Point p : polygon)
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  bool flat_x = true, flat_y = true;
  for (const Point p : kept) {
    flat_x &= p.x == kept.front().x;
    flat_y &= p.y == kept.front().y;
  }
  if (kept.size() < 3 || flat_x || flat_y) return {};
  return kept;
}

std::vector<std::vector<Point>> clip_line(const std::vector<Point>& line, const Window& window) {
  std::vector<std::vector<Point>> pieces;
  bool open = false;  // whether the last piece ends at the next line's start
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    Point a = line[k], b = line[k + 1];
    bool inside = true;
    for (const Side& side : sides_of(window)) {
      inside &= side.keeps(a) || side.keeps(b);
      if (!inside) break;
      if (!side.keeps(a)) a = side.crossing(a, b);
      if (!side.keeps(b)) b = side.crossing(a, b);
    }
    if (!inside || a == b) {
      open = false;
      continue;
    }
    if (!open || pieces.back().back() != a) pieces.push_back({a});
    pieces.back().push_back(b);
    open = b == line[k + 1];
  }
  return pieces;
}

}  // namespace cover
