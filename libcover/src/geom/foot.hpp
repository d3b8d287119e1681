// Where a perpendicular meets a line, as exactly as doubles tell.
// Tested by tests/unit/geom/foot_test.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {

/// The foot on the line from `a` to `b` of the perpendicular through `p`, where that line is
/// parallel to an axis: then it is no rounding.
///
/// REQUIRES: a != b
inline std::optional<Point> exact_foot(Point a, Point b, Point p) {
  if (a.y == b.y) return Point{p.x, a.y};
  if (a.x == b.x) return Point{a.x, p.y};
  return std::nullopt;
}

/// The point on the line from `a` to `b` at this part of the way, measured from the nearer end, so
/// that what is exact there stays so.
inline Point at_part(Point a, Point b, double part) {
  return part <= 0.5 ? a + part * (b - a) : b + (part - 1) * (b - a);
}

/// Where on the line along `along` the foot of a point is that lies at `to` from its start: 0 at
/// the start, 1 at the end. Rounded, as all that follow.
///
/// REQUIRES: along != 0
constexpr double part_on_line(Vector along, Vector to) {
  return dot(to, along) / squared_length(along);
}

/// The same of the line from `a` to `b` and the point `p`.
///
/// REQUIRES: a != b
constexpr double part_on_line(Point a, Point b, Point p) { return part_on_line(b - a, p - a); }

/// The foot of `p` on the line from `a` to `b`.
///
/// REQUIRES: a != b
inline Point nearest_on_line(Point a, Point b, Point p) {
  return at_part(a, b, part_on_line(a, b, p));
}

/// Where on the segment along `along` the place is that is nearest to a point at `to` from its
/// start: from 0 to 1. The segment may have no length.
inline double part_on_segment(Vector along, Vector to) {
  return squared_length(along) > 0 ? std::clamp(part_on_line(along, to), 0.0, 1.0) : 0;
}

/// The same of the segment from `a` to `b` and the point `p`; `a` and `b` may be the same.
inline double part_on_segment(Point a, Point b, Point p) { return part_on_segment(b - a, p - a); }

/// The place of the segment from `a` to `b` that is nearest to `p`; `a` and `b` may be the same.
inline Point nearest_on_segment(Point a, Point b, Point p) {
  return a + part_on_segment(a, b, p) * (b - a);
}

/// From the area, so that it keeps its digits where `p` is nearly on the line.
///
/// REQUIRES: a != b
inline double distance_to_line(Point p, Point a, Point b) {
  return std::abs(cross(b - a, p - a)) / length(b - a);
}

/// `a` and `b` may be the same.
inline double distance_to_segment(Point p, Point a, Point b) {
  return length(p - nearest_on_segment(a, b, p));
}

/// How far along a segment, however short, the foot of a point is that lies at `to` from its start.
///
/// REQUIRES: along != 0; the foot lies on the segment, up to rounding
/// Returns:  in parts of the segment, from 0 to 1
inline double share_of_tiny(Vector along, Vector to) {
  const int octave = std::ilogb(std::max(std::abs(along.x), std::abs(along.y)));
  const Vector unit{std::ldexp(along.x, -octave), std::ldexp(along.y, -octave)};
  return std::clamp(std::ldexp(part_on_line(unit, to), -octave), 0.0, 1.0);
}

/// The foot on the segment from `a` to `b`; rounded, but exact where rounding leaves `p` in the
/// diametral disk of a piece, as it does in thin layers, and where doubles hold it. The same from
/// both ends.
///
/// REQUIRES: a != b; the foot lies between them
inline Point foot_on(Point a, Point b, Point p) {
  const Vector along = b - a;
  double from_a = part_on_line(along, p - a);
  double from_b = part_on_line(along, p - b);
  if (squared_length(along) < 0x1p-900) {  // squares of such lengths leave the range of doubles
    from_a = share_of_tiny(along, p - a);
    from_b = -share_of_tiny(-1 * along, p - b);
  }
  const Point foot = from_a <= 0.5 ? a + from_a * along : b + from_b * along;
  if (compare_with_90_degrees(a, p, foot) != Sign::positive &&
      compare_with_90_degrees(foot, p, b) != Sign::positive)
    return foot;
  return exact_foot(a, b, p).value_or(foot);
}

}  // namespace cover
