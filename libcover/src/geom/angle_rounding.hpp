// What coordinates in doubles can do to an angle, and what is obtuse nevertheless.
#pragma once

#include <algorithm>

#include "geom/predicates.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {

/// Radians: angles so near to a right one are as good as right. Feet of perpendiculars are so up to
/// rounding only, and no solver can tell.
inline constexpr double kAsGoodAsRight = 1e-9;

/// What rounding a triangle's corners to double can change in its angles, in radians: a few units
/// in the last place of the largest coordinate over the shortest edge.
inline double angle_rounding(Point a, Point b, Point c, double largest_coordinate) {
  const double shortest = std::min({length(b - a), length(c - b), length(a - c)});
  // Each of two corners moves by at most spacing / sqrt 2 against the third along either edge.
  return 4 * spacing_at(largest_coordinate) / shortest;
}

/// How the largest angle of a triangle compares with 90 degrees.
enum class Blunt {
  no,           ///< at most 90 degrees, exactly
  by_rounding,  ///< above, by no more than 1e-9 radians or what rounding of corners can make
  yes,          ///< above by more: what is called obtuse
};

/// How the angle at `apex`, the largest one of the triangle, compares.
/// EXACT: whether it is Blunt::no
inline Blunt bluntness(Point p, Point apex, Point q, double largest_coordinate) {
  const double area = std::abs(cross(p - apex, q - apex));
  const double beyond = -dot(p - apex, q - apex);  // above zero: obtuse
  if (beyond > kAsGoodAsRight * area)
    return beyond > area * angle_rounding(apex, p, q, largest_coordinate) ? Blunt::yes
                                                                          : Blunt::by_rounding;
  if (beyond < -kAsGoodAsRight * area) return Blunt::no;
  return compare_with_90_degrees(p, apex, q) == Sign::positive ? Blunt::by_rounding : Blunt::no;
}

}  // namespace cover
