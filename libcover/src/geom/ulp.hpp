// Units in the last place.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <cover/point.hpp>

#include "base/numbers.hpp"

namespace cover {

/// How far the next larger double is from |x|.
inline double spacing_at(double x) {
  x = std::abs(x);
  return std::nextafter(x, kInfinity) - x;
}

/// The largest |x| or |y|; 0 without points.
inline double largest_coordinate(std::span<const Point> points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

/// The spacing of doubles at the largest coordinate: how much rounding can move a point.
inline double spacing_of(std::span<const Point> points) {
  return spacing_at(largest_coordinate(points));
}

}  // namespace cover
