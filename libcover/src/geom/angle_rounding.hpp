// What coordinates in doubles can do to an angle, and what is obtuse nevertheless.
// The one definition of obtuse: docs/nonobtuse_method.md says why it is this one.
// Tested by tests/unit/geom/angle_rounding_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geom/predicates.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {

/// What rounding a triangle's corners to double can change in its angles, in radians: a few units
/// in the last place of the largest coordinate over the shortest edge.
inline double angle_rounding(Point a, Point b, Point c, double largest_coordinate) {
  const double shortest = std::min({length(b - a), length(c - b), length(a - c)});
  // Each of two corners moves by at most spacing / sqrt 2 against the third along either edge.
  return 4 * spacing_at(largest_coordinate) / shortest;
}

/// Promise 3: nu of the largest angle of a region whose sides are seen under gamma_opt = pi -
/// `nu_opt` at least.
inline double promised_nu(double nu_opt) { return std::min(nu_opt / 2, std::numbers::pi / 6); }
/// The part of that which is left where angles themselves are rounded.
inline constexpr double kNuRounded = 1 - 1e-9;

/// How the largest angle of a triangle compares with 90 degrees.
enum class Blunt {
  no,           ///< at most 90 degrees, exactly
  by_rounding,  ///< above, by no more than what rounding of its own corners can make
  yes,          ///< above by more: what is called obtuse
};

/// How the angle at `apex`, the largest one of the triangle, compares. Nothing but its corners
/// counts, so that a triangle is judged alike in a region, in the whole mesh and read from a file.
/// The order of `p` and `q` does not matter.
/// EXACT: whether it is Blunt::no
inline Blunt bluntness(Point p, Point apex, Point q) {
  if (compare_with_90_degrees(p, apex, q) != Sign::positive) return Blunt::no;
  const Vector u = p - apex, v = q - apex;
  const std::array<Point, 3> corners{p, apex, q};
  const double allowed = angle_rounding(p, apex, q, largest_coordinate(corners));
  return -dot(u, v) > std::abs(cross(u, v)) * allowed ? Blunt::yes : Blunt::by_rounding;
}

/// The same of the largest angle of the triangle, wherever that is.
inline Blunt bluntness_of(Point a, Point b, Point c) {
  return std::max({bluntness(c, a, b), bluntness(a, b, c), bluntness(b, c, a)});
}

}  // namespace cover
