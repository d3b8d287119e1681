// Exact predicates on double coordinates. Topology is decided here and nowhere else.
#pragma once

#include <cover/point.hpp>

namespace cover {

/// Sign of an exact computation.
enum class Sign { negative = -1, zero = 0, positive = 1 };

/// Positive if a, b, c make a left turn, zero if they are collinear.
///
/// EXACT: yes; a floating-point filter answers nearly always.
/// Cost:  a few flops; big-number arithmetic only where the filter fails.
Sign orientation(Point a, Point b, Point c);

/// Positive if the direction from c to d is on the left of the one from a to b, zero if they are
/// parallel.
///
/// EXACT: yes
Sign cross_sign(Point a, Point b, Point c, Point d);

/// Positive if d lies inside the circle through a, b, c.
///
/// REQUIRES: a, b, c counter-clockwise
/// EXACT:    yes
Sign in_circle(Point a, Point b, Point c, Point d);

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
