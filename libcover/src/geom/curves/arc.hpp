// Arcs over chords, and the area and the Jacobian of triangles with curved edges.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <cover/arcs.hpp>
#include <cover/point.hpp>
#include <cover/pslg.hpp>

#include "geom/vector.hpp"

namespace cover {

/// In Segment::circle: the segment was a chord and is straight for good, since what was put on it
/// had no room on the arc, or its ends were moved.
inline constexpr std::uint32_t kStraightened = 0x80000000U;

/// The circle that `segment` is a chord of; nullptr: it is straight.
inline const ArcCircle* circle_of(const Pslg& pslg, const Segment& segment) {
  const bool is_chord = segment.circle != 0 && (segment.circle & kStraightened) == 0;
  return is_chord ? &pslg.circles[segment.circle - 1] : nullptr;
}

/// By how much a point is off a circle, and whether that is too much for the end of a chord.
inline double distance_to_circle(const ArcCircle& circle, Point p) {
  return std::abs(length(p - circle.centre) - circle.radius);
}
inline bool is_off_circle(const ArcCircle& circle, Point p) {
  constexpr double kOffCircle = 1e-3;  // of the radius: drawings round angles and centres
  return distance_to_circle(circle, p) > kOffCircle * circle.radius;
}

/// Makes a chord straight for good.
inline void straighten(Segment& segment) {
  if (segment.circle != 0) segment.circle |= kStraightened;
}

/// The arc between two points of a circle, the shorter one. Where the points are off the circle by
/// rounding, the arc goes through them with the circle's radius.
class ArcOver {
 public:
  /// REQUIRES: a differs from b
  ArcOver(const ArcCircle& circle, Point a, Point b);

  /// The point at this share of the way along the arc, from a at 0 to b at 1.
  [[nodiscard]] Point at(double share) const;
  /// The middle of the arc.
  [[nodiscard]] Point middle() const { return at(0.5); }
  /// The point at the same share of the arc's angle as `p` is of the chord.
  [[nodiscard]] Point above(Point p) const;
  /// Whether `p` lies on the circle of the arc up to rounding: 2^-40 of its size and of its place.
  [[nodiscard]] bool is_on_circle(Point p) const {
    return distance_from_circle(p) <= rounding_at(p);
  }
  /// How far `p` is from the circle of the arc, without loss of digits however large that is, and
  /// what of it may be rounding of the circle.
  [[nodiscard]] double distance_from_circle(Point p) const;
  [[nodiscard]] double rounding_at(Point p) const;
  /// Which share of the way along the arc leads to `p`, a point of the circle: from 0 to 1 on the
  /// arc, below or above these beside it.
  [[nodiscard]] double share_of(Point p) const;
  /// Whether `p` lies on the chord or between it and the arc.
  [[nodiscard]] bool cuts_off(Point p) const;

 private:
  /// From the centre to `p`: along the chord, and towards the middle of the arc.
  [[nodiscard]] Vector from_centre(Point p) const;

  Point a_, b_;
  Point centre_;  ///< of the circle through a and b
  double radius_ = 0;
  double height_ = 0;      ///< of the chord over the centre
  double half_angle_ = 0;  ///< from the middle to an end
  double turn_ = 1;        ///< 1: counter-clockwise from a to b
};

/// Where two circles cross, or touch up to rounding: two points, or none. That place is known up to
/// the root of rounding where they touch.
std::vector<Point> common_points(const ArcCircle& one, const ArcCircle& other);

/// A triangle of second order: corners, then the middles of its edges from the first one on.
using CurvedTriangle = std::array<Point, 6>;

/// Whether the Jacobian of the triangle is positive everywhere, proven: all six coefficients of
/// Bernstein's form are positive, exactly.
bool has_positive_jacobian(const CurvedTriangle& triangle);

/// What a quadratic edge from a to b over the node m adds to the area on its left.
double area_beside_chord(Point a, Point b, Point m);

}  // namespace cover
