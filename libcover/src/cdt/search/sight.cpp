// In each triangle the walk leaves by an edge that has the target strictly on its far side; of two
// such edges, by the one on the side of their common corner on which the line passes. It never
// turns back over the edge by which it came, and the distance to the target along the line grows
// from edge to edge, so it ends.
// Tested by tests/unit/almond/fill/refine_large_angles_test.cpp.
#include "cdt/search/sight.hpp"

#include <optional>

#include "geom/predicates.hpp"

namespace cover {

Walk walk_straight(const Triangulation& cdt, std::uint32_t start, Point from, Point to) {
  Walk walk;
  walk.at.triangle = start;
  std::optional<Corner> entered;
  for (; walk.passed <= cdt.triangles.size(); ++walk.passed) {
    const Triangle& f = cdt.triangles[walk.at.triangle];
    std::optional<Corner> leave;
    for (const Corner i : kCorners) {
      if (i == entered) continue;
      const Point a = cdt.points[f.v[i.next()]];
      const Point b = cdt.points[f.v[i.previous()]];
      if (orientation(a, b, to) != Sign::negative) continue;
      // Edge i runs from a to b. If an edge was chosen before, the two share a corner.
      if (!leave) {
        leave = i;
      } else {
        const bool shares_a = leave == i.previous();
        const Sign side = orientation(from, to, shares_a ? a : b);
        const bool through_this = shares_a ? side != Sign::positive : side == Sign::positive;
        if (through_this) leave = i;
      }
    }
    if (!leave) {
      walk.arrived = true;
      return walk;
    }
    walk.at.edge = *leave;
    const std::uint32_t next = f.n[*leave];
    if (next == kNone || f.is_locked(*leave)) return walk;
    entered = cdt.triangles[next].edge_to(walk.at.triangle);
    walk.at.triangle = next;
  }
  return walk;
}

}  // namespace cover
