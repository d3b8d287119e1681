// See measure_boxes.hpp.
#include "target/report/measure_boxes.hpp"

#include <cmath>
#include <utility>

#include "base/none.hpp"
#include "cdt/couplings.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/predicates.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"
#include "target/report/sorted_corners.hpp"

namespace cover {
namespace {

/// Of the triangles from `first` to before `last`.
BoxMethod measure_some_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                             const Opposites& opposites, std::size_t first, std::size_t last) {
  BoxMethod box;
  const auto& [cots, across] = opposites;
  for (std::size_t t = first; t < last; ++t) {
    const Point corner[3] = {points[triangles[t][0]], points[triangles[t][1]],
                             points[triangles[t][2]]};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto h = static_cast<std::uint32_t>(3 * t + i);
      const Point from = corner[i], to = corner[(i + 1) % 3], beside = corner[(i + 2) % 3];
      // |e| d_e / 2 with d_e = |e| |cot| / 2, the distance from the edge's midpoint to the
      // circumcentre
      box.box_area += squared_length(to - from) * std::abs(cots[h]) / 4;
      const std::uint32_t twin = across[h];
      if (twin == kNone) {
        const bool is_obtuse = cots[h] < kNearRight && bluntness(from, beside, to) == Blunt::yes;
        box.obtuse_sides += is_obtuse ? 1 : 0;
      } else if (h < twin && cots[h] + cots[twin] < -kNearRight) {
        const std::uint32_t beyond = HalfEdges::previous(twin);
        if (in_circle(from, to, beside, points[triangles[beyond / 3][beyond % 3]]) ==
            Sign::positive)
          ++box.non_delaunay_edges;
      }
    }
  }
  return box;
}

}  // namespace

Opposites opposites_of(std::span<const Point> points, std::span<const IndexTriple> triangles,
                       std::span<const IndexPair> sides, const Team& team,
                       std::vector<std::uint32_t> across) {
  Opposites of;
  of.cots.resize(3 * triangles.size());
  team.each_range(triangles.size(), kMeasuredAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto& [i, j, k] = triangles[t];
      const Point corners[3] = {points[i], points[j], points[k]};
      const double area = doubled_area(corners[0], corners[1], corners[2]);
      for (std::size_t h = 0; h < 3; ++h)
        of.cots[3 * t + h] =
            cotangent(corners[h], corners[(h + 2) % 3], corners[(h + 1) % 3], area);
    }
  });
  of.across = across.size() == of.cots.size() ? std::move(across)
                                              : across_edges(points.size(), triangles, sides, team);
  return of;
}

BoxMethod measure_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        const Opposites& opposites, const Team& team) {
  std::vector<BoxMethod> parts(Team::ranges(triangles.size(), kMeasuredAtATime));
  team.each_range(triangles.size(), kMeasuredAtATime, [&](std::size_t first, std::size_t last) {
    parts[first / kMeasuredAtATime] = measure_some_boxes(points, triangles, opposites, first, last);
  });
  BoxMethod sum;
  for (const BoxMethod& part : parts) sum += part;
  return sum;
}
BoxMethod measure_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        std::span<const IndexPair> sides) {
  return measure_boxes(points, triangles, opposites_of(points, triangles, sides, Team()), Team());
}

}  // namespace cover
