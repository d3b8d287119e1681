// Tested by tests/unit/pipeline/cover_mesh_test.cpp.
#include "target/report/flat_on_hull.hpp"

#include <algorithm>
#include <utility>

#include "cdt/couplings.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kFlatOnHull = 8;  ///< spacings of doubles that rounding can move a point by

}  // namespace

std::vector<IndexTriple> without_flat_on_hull(const RegionBoundary& boundary,
                                              std::span<const Point> points,
                                              std::span<const IndexTriple> triangles) {
  const double most = kFlatOnHull * spacing_at(largest_coordinate(points));
  const std::vector<std::uint32_t> across = across_edges(points.size(), triangles, boundary.sides);
  std::vector<bool> is_flat(triangles.size(), false);
  struct HullEdge {
    Point from, to;
    std::uint32_t half_edge;
  };
  std::vector<HullEdge> hull;
  for (std::uint32_t h = 0; h < across.size(); ++h) {
    const IndexPair edge{triangles[h / 3][h % 3], triangles[h / 3][(h + 1) % 3]};
    const auto side = std::lower_bound(boundary.sides.begin(), boundary.sides.end(), edge);
    if (side == boundary.sides.end() || *side != edge ||
        boundary.segments[static_cast<std::size_t>(side - boundary.sides.begin())] != kHullSide)
      continue;
    hull.push_back({points[edge[0]], points[edge[1]], h});
  }
  // What one side has found ends the search from others: in the order of the verifier.
  std::sort(hull.begin(), hull.end(), [](const HullEdge& a, const HullEdge& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });
  std::vector<std::uint32_t> stack;
  for (const HullEdge& side : hull) {
    const Point from = side.from;
    const Vector along = side.to - from;
    for (stack.push_back(side.half_edge / 3); !stack.empty();) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      if (is_flat[t] || std::any_of(triangles[t].begin(), triangles[t].end(), [&](std::uint32_t v) {
            return cross(along, points[v] - from) >= most * length(along);
          }))
        continue;
      is_flat[t] = true;
      for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i) {
        if (across[i] != kNone) stack.push_back(across[i] / 3);
      }
    }
  }
  std::vector<IndexTriple> rest;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!is_flat[t]) rest.push_back(triangles[t]);
  }
  return rest;
}

}  // namespace cover
