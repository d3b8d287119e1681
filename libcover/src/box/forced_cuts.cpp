// Tested by tests/unit/box/least_cuts_test.cpp.
#include "box/forced_cuts.hpp"

#include <algorithm>

#include "box/encroached_sides.hpp"
#include "box/least_cuts.hpp"
#include "cdt/sides.hpp"

namespace cover {

std::vector<EncroachedSegment> encroached_segments(const RegionBoundary& boundary,
                                                   const Triangulation& cdt) {
  const std::vector<EdgeRef> at = locate_sides(cdt, boundary.sides);
  std::vector<EncroachedSegment> found;
  ObstacleFinder finder(cdt);
  for (const EncroachedSide& e : encroached_sides(cdt, at)) {
    const Point a = boundary.points[boundary.sides[e.side][0]],
                b = boundary.points[boundary.sides[e.side][1]];
    std::vector<Obstacle> obstacles = finder.obstacles(at[e.side]);
    if (b < a) obstacles = turned_round(std::move(obstacles));
    found.push_back(
        {boundary.segments[e.side], a, b, boundary.points[e.vertex], std::move(obstacles)});
  }
  return found;
}

ForcedCuts forced_cuts(std::span<const std::vector<EncroachedSegment>> regions) {
  std::vector<const EncroachedSegment*> all;
  for (const auto& region : regions) {
    for (const EncroachedSegment& e : region) {
      if (e.segment != kHullSide) all.push_back(&e);
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto* x, const auto* y) { return x->segment < y->segment; });
  ForcedCuts forced;
  for (std::size_t k = 0; k < all.size();) {
    const SegmentId segment = all[k]->segment;
    std::vector<Obstacle> obstacles;
    for (; k < all.size() && all[k]->segment == segment; ++k)
      obstacles = merged(std::move(obstacles), all[k]->obstacles);
    ++forced.segments;
    forced.least += std::max<std::size_t>(1, least_cuts(obstacles));
  }
  return forced;
}

}  // namespace cover
