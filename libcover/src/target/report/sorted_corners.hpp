// The corners of a triangle by its angles, for what measures them.
// Tested by tests/unit/target/report/measure_angles_test.cpp.
#pragma once

#include <cstddef>

#include <cover/point.hpp>

#include "geom/vector.hpp"
#include "target/angle_limit.hpp"

namespace cover {

/// Triangles that one thread measures at a time. The same for any team: areas are summed in the
/// same order.
inline constexpr std::size_t kMeasuredAtATime = 1 << 17;
/// In cotangents: from here on doubles tell that an angle is acute, or obtuse.
inline constexpr double kNearRight = 1e-9;

/// A triangle from its largest angle's corner on.
struct SortedCorners {
  Point apex;  ///< corner of the largest angle, opposite to the longest edge
  Point p, q;  ///< the others, counter-clockwise; the smallest angle is at `sharp`
  Point sharp;
  Point blunt;
};

inline SortedCorners sort_corners(Point a, Point b, Point c) {
  const double ab = squared_length(b - a), bc = squared_length(c - b), ca = squared_length(a - c);
  // Looked up, without a branch: nobody can predict which corner it is.
  const Point corner[5] = {a, b, c, a, b};
  const double opposite[5] = {bc, ca, ab, bc, ca};
  const bool is_first = (bc >= ab) & (bc >= ca);
  const std::size_t apex = is_first ? 0 : ca >= ab ? 1 : 2;
  const std::size_t sharp =
      apex + 1 + static_cast<std::size_t>(opposite[apex + 2] < opposite[apex + 1]);
  return {corner[apex], corner[apex + 1], corner[apex + 2], corner[sharp],
          corner[2 * apex + 3 - sharp]};
}

/// Of the angle at `corner` of a triangle.
inline double cotangent(Point a, Point corner, Point b, double doubled_area) {
  return dot(a - corner, b - corner) / doubled_area;
}

/// pi minus the largest angle of a triangle.
inline double largest_nu_of(Point a, Point b, Point c) {
  const SortedCorners s = sort_corners(a, b, c);
  return accurate_nu_at(s.p, s.apex, s.q);
}

}  // namespace cover
