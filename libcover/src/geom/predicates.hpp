// Exact predicates on double coordinates. Topology is decided here and nowhere else.
//
// A forward error bound decides nearly every call, in line; the rest goes to exact arithmetic.
// Bounds for orientation and in_circle: J. R. Shewchuk, Adaptive precision floating-point
// arithmetic, DCG 18 (1997), stage A; valid as long as no product under- or overflows, which
// is checked by the size of the permanent.
#pragma once

#include <cmath>

#include <cover/point.hpp>

namespace cover {

/// Sign of an exact computation.
enum class Sign { negative = -1, zero = 0, positive = 1 };

namespace filter {

inline constexpr double kEpsilon = 0x1p-53;                                  // half an ulp of 1
inline constexpr double kOrientationBound = (3 + 16 * kEpsilon) * kEpsilon;  // Shewchuk, fig. 21
inline constexpr double kInCircleBound = (10 + 96 * kEpsilon) * kEpsilon;    // Shewchuk, fig. 23
inline constexpr double kSafeSmall = 0x1p-900;  // no product of the filters has lost bits

constexpr Sign sign_of(double x) {
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}
Sign exact_orientation(Point a, Point b, Point c);
Sign exact_in_circle(Point a, Point b, Point c, Point d);

}  // namespace filter

/// Positive if a, b, c make a left turn, zero if they are collinear.
///
/// EXACT: yes; a floating-point filter answers nearly always.
/// Cost:  a few flops; big-number arithmetic only where the filter fails.
inline Sign orientation(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double permanent = std::abs(left) + std::abs(right);
  if (permanent > filter::kSafeSmall && std::abs(det) > filter::kOrientationBound * permanent)
    return filter::sign_of(det);
  return filter::exact_orientation(a, b, c);
}

/// Positive if the direction from c to d is on the left of the one from a to b, zero if they are
/// parallel.
///
/// EXACT: yes
Sign cross_sign(Point a, Point b, Point c, Point d);

/// Positive if d lies inside the circle through a, b, c.
///
/// REQUIRES: a, b, c counter-clockwise
/// EXACT:    yes
inline Sign in_circle(Point a, Point b, Point c, Point d) {
  const double adx = a.x - d.x, ady = a.y - d.y;
  const double bdx = b.x - d.x, bdy = b.y - d.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  const double bc = bdx * cdy, cb = cdx * bdy;
  const double ca = cdx * ady, ac = adx * cdy;
  const double ab = adx * bdy, ba = bdx * ady;
  const double a2 = adx * adx + ady * ady;
  const double b2 = bdx * bdx + bdy * bdy;
  const double c2 = cdx * cdx + cdy * cdy;
  const double det = a2 * (bc - cb) + b2 * (ca - ac) + c2 * (ab - ba);
  const double permanent = (std::abs(bc) + std::abs(cb)) * a2 + (std::abs(ca) + std::abs(ac)) * b2 +
                           (std::abs(ab) + std::abs(ba)) * c2;
  if (permanent > filter::kSafeSmall && std::abs(det) > filter::kInCircleBound * permanent)
    return filter::sign_of(det);
  return filter::exact_in_circle(a, b, c, d);
}

/// Sign of the angle a-p-b minus 120 degrees.
///
/// With u = a - p, v = b - p the angle is at least 120 degrees where u.v < 0 and
/// (u x v)^2 <= 3 (u.v)^2; the sign of that polynomial is computed exactly.
/// REQUIRES: a, b differ from p
/// EXACT:    yes
Sign compare_with_120_degrees(Point a, Point p, Point b);

/// Sign of the angle a-p-b minus 90 degrees: minus the sign of (a - p).(b - p).
/// EXACT: yes
Sign compare_with_90_degrees(Point a, Point p, Point b);

}  // namespace cover
