// Tested by tests/unit/geom/rings/is_simple_test.cpp.
#include "geom/rings/is_simple.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <vector>

namespace cover {

bool is_simple(std::span<const Point> ring) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> points;
  points.reserve(ring.size());
  for (const Point p : ring) points.emplace_back(p.x, p.y);
  return CGAL::is_simple_2(points.begin(), points.end(), Kernel());
}

}  // namespace cover
