// See holds_bound.hpp.
#include "target/report/holds_bound.hpp"

#include <algorithm>

#include "geom/angle_rounding.hpp"
#include "geom/ulp.hpp"
#include "target/report/sorted_corners.hpp"

namespace cover {

bool holds_bound(std::span<const Point> points, std::span<const IndexTriple> triangles,
                 Angle nu_bound) {
  const double largest = largest_coordinate(points);
  return std::all_of(triangles.begin(), triangles.end(), [&](const IndexTriple& t) {
    const Point a = points[t[0]], b = points[t[1]], c = points[t[2]];
    const double nu = largest_nu_of(a, b, c);
    return nu >= nu_bound.in_radians() ||
           nu + angle_rounding(a, b, c, largest) >= nu_bound.in_radians();
  });
}

std::size_t count_above(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        Angle wanted) {
  const double least_nu = wanted.supplement().in_radians();
  const auto is_above = [&](const IndexTriple& t) {
    return largest_nu_of(points[t[0]], points[t[1]], points[t[2]]) < least_nu;
  };
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), is_above));
}

}  // namespace cover
