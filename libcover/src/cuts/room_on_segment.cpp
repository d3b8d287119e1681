// Tested by tests/unit/sizes/sizes_test.cpp, through split_interfaces().
#include "cuts/room_on_segment.hpp"

#include <algorithm>
#include <cmath>

#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kThinnest =
    4;  ///< units in the last place: no cut is nearer to a triangle's edges

}  // namespace

bool is_off_line(Point a, Point b, Point p) {
  return std::abs(cross(b - a, p - a)) > kThinnest * spacing_of(std::array{a, b}) * length(b - a);
}

bool has_room_on_segment(Point a, Point b, Point p, std::span<const Point> apexes) {
  const double room = kThinnest * spacing_of(std::array{a, b});
  return std::all_of(apexes.begin(), apexes.end(), [&](Point c) {
    return std::abs(cross(c - a, p - a)) > room * length(c - a) &&
           std::abs(cross(c - b, p - b)) > room * length(c - b);
  });
}

}  // namespace cover
