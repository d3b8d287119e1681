// What three corners make: an area, a centroid, a circle. Rounded, but for where a point lies.
// Tested by tests/unit/geom/triangle_test.cpp.
#pragma once

#include <array>

#include "geom/predicates.hpp"
#include "geom/topology/corner.hpp"
#include "geom/vector.hpp"

namespace cover {

/// Twice the area of the triangle: positive if its corners are counter-clockwise.
constexpr double doubled_area(Point a, Point b, Point c) { return cross(b - a, c - a); }

constexpr Point centroid(Point a, Point b, Point c) { return a + (1.0 / 3) * ((b - a) + (c - a)); }

/// Whether `p` lies inside the counter-clockwise triangle, on no edge of it.
/// EXACT
inline bool is_strictly_inside(Point a, Point b, Point c, Point p) {
  return orientation(a, b, p) == Sign::positive && orientation(b, c, p) == Sign::positive &&
         orientation(c, a, p) == Sign::positive;
}

/// The centre of the circle through three points, with the least cancellation if the angle at
/// `apex` is the largest: the two sides there are the short ones.
constexpr Point circumcentre_from(Point apex, Point p, Point q) {
  const Vector u = p - apex, v = q - apex;
  const double u2 = squared_length(u), v2 = squared_length(v), twice = 2 * cross(u, v);
  return apex + Vector{(u2 * v.y - v2 * u.y) / twice, (v2 * u.x - u2 * v.x) / twice};
}

/// The same, from the corner with the largest angle.
inline Point circumcentre(Point a, Point b, Point c) {
  const std::array<Point, 3> p{a, b, c};
  Corner k;
  double longest = -1;
  for (const Corner i : kCorners) {
    const double l = squared_length(p[i.next()] - p[i.previous()]);
    if (l > longest) longest = l, k = i;
  }
  return circumcentre_from(p[k], p[k.next()], p[k.previous()]);
}

}  // namespace cover
