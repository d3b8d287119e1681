// Tested by tests/unit/limits/angles/angles_around_test.cpp.
#include "limits/angles/angles_around.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"

namespace cover {

AnglesAround AnglesAround::of(std::span<const Point> points, std::span<const IndexTriple> triangles,
                              std::size_t vertices) {
  AnglesAround around;
  around.least_cot.assign(points.size(), kInfinity);
  around.most_cot.assign(points.size(), -kInfinity);
  for (const IndexTriple& t : triangles) {
    const Point a = points[t[0]], b = points[t[1]], c = points[t[2]];
    const double area = doubled_area(a, b, c);
    const double cots[3] = {dot(b - a, c - a) / area, dot(c - b, a - b) / area,
                            dot(a - c, b - c) / area};
    const auto [least, most] = std::minmax({cots[0], cots[1], cots[2]});
    for (const std::uint32_t v : t) {
      around.least_cot[v] = std::min(around.least_cot[v], least);
      around.most_cot[v] = std::max(around.most_cot[v], most);
    }
  }
  around.least_near = around.least_cot;
  for (const IndexTriple& t : triangles) {
    const double least =
        std::min({around.least_cot[t[0]], around.least_cot[t[1]], around.least_cot[t[2]]});
    for (const std::uint32_t v : t) around.least_near[v] = std::min(around.least_near[v], least);
  }
  for (auto* of_all : {&around.least_cot, &around.most_cot, &around.least_near})
    of_all->resize(vertices);
  return around;
}

}  // namespace cover
