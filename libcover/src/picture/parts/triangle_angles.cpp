// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/parts/triangle_angles.hpp"

#include <algorithm>
#include <array>

#include <cover/angle.hpp>

#include "geom/vector.hpp"

namespace cover {
namespace {

std::array<double, 3> angles_in_radians(const TriangleSoup& soup, std::size_t triangle) {
  const auto& [a, b, c] = soup.triangles[triangle];
  const Point p = soup.points[a], q = soup.points[b], r = soup.points[c];
  return {angle_at(q, p, r), angle_at(r, q, p), angle_at(p, r, q)};
}

std::vector<double> value_of_each(const TriangleSoup& soup,
                                  double (*value)(const TriangleSoup&, std::size_t)) {
  std::vector<double> values(soup.triangles.size());
  for (std::size_t t = 0; t < values.size(); ++t) values[t] = value(soup, t);
  return values;
}

}  // namespace

double largest_angle(const TriangleSoup& soup, std::size_t triangle) {
  const std::array angles = angles_in_radians(soup, triangle);
  return Angle::radians(*std::max_element(angles.begin(), angles.end())).in_degrees();
}

double smallest_angle(const TriangleSoup& soup, std::size_t triangle) {
  const std::array angles = angles_in_radians(soup, triangle);
  return Angle::radians(*std::min_element(angles.begin(), angles.end())).in_degrees();
}

std::vector<double> largest_angles(const TriangleSoup& soup) {
  return value_of_each(soup, largest_angle);
}

std::vector<double> smallest_angles(const TriangleSoup& soup) {
  return value_of_each(soup, smallest_angle);
}

}  // namespace cover
