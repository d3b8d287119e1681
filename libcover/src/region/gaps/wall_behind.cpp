// Tested by tests/unit/region/region_graph_test.cpp.
#include "region/gaps/wall_behind.hpp"

#include "geom/foot.hpp"
#include "geom/vector.hpp"

namespace cover {

std::optional<EdgeRef> wall_behind(const Triangulation& triangulation, std::uint32_t w,
                                   EdgeRef edge, double reach) {
  constexpr int kMostSteps = 64;
  const auto at = [&](std::uint32_t p) { return triangulation.points[p]; };
  for (int step = 0; step < kMostSteps; ++step) {
    const Triangle& f = triangulation.triangles[edge.triangle];
    if (f.is_locked(edge.edge)) return edge;
    const std::uint32_t next = f.n[edge.edge];
    if (next == kNone) return std::nullopt;
    const Triangle& g = triangulation.triangles[next];
    const Corner back = g.edge_to(edge.triangle);
    // Of the two edges on the far side the one that runs past w: its ends are on both sides of w.
    const Vector along = at(f.v[edge.edge.previous()]) - at(f.v[edge.edge.next()]);
    edge = {next, dot(along, at(g.v[back]) - at(w)) > 0 ? back.next() : back.previous()};
    if (distance_to_line(at(w), at(g.v[edge.edge.next()]), at(g.v[edge.edge.previous()])) >= reach)
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace cover
