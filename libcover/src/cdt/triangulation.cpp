// Tested by tests/unit/quality/quality_region_test.cpp.
#include "cdt/triangulation.hpp"

#include <utility>

#include "geom/topology/half_edges.hpp"

namespace cover {

Triangulation with_neighbours(std::vector<Point> points, std::span<const IndexTriple> triangles) {
  Triangulation out;
  const std::vector<std::uint32_t> opposite = opposite_half_edges(points.size(), triangles);
  out.points = std::move(points);
  out.triangles.resize(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    out.triangles[t].v = triangles[t];
    out.triangles[t].locked = 7;       // any edge may be a side: locate_sides looks at locked ones
    for (const Corner i : kCorners) {  // half-edge i starts at corner i: opposite to i + 2
      const std::uint32_t twin = opposite[3 * t + i];
      out.triangles[t].n[i.previous()] = twin == kNone ? kNone : twin / 3;
    }
  }
  return out;
}

}  // namespace cover
