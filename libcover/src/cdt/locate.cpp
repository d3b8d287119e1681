// A stochastic visibility walk: from triangle to triangle across an edge that has the point beyond
// it. In a triangulation that is not Delaunay (a constrained one need not be) a walk that always
// tries the edges in the same order may go round for ever; starting with a random edge it ends with
// probability 1. The generator is our own, so that the walk is the same everywhere.
// Ref: O. Devillers, S. Pion, M. Teillaud, Walking in a triangulation, IJFCS 13 (2002).
// Tested by tests/unit/cdt/locate_test.cpp.
#include "cdt/locate.hpp"

#include "geom/predicates.hpp"

namespace cover {

Location Locator::locate(Point p) {
  const auto& triangles = triangulation_.triangles;
  const auto& points = triangulation_.points;
  if (triangles.empty()) return {};
  for (;;) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;  // Knuth's MMIX generator
    const Triangle& f = triangles[last_];
    int i = static_cast<int>((state_ >> 33) % 3);
    int edges_through = 0, on_edge = 0, edge_sum = 0, beyond = -1;
    for (int k = 0; k < 3 && beyond < 0; ++k, i = next3(i)) {
      const Sign side = orientation(points[f.v[static_cast<std::size_t>(next3(i))]],
                                    points[f.v[static_cast<std::size_t>(prev3(i))]], p);
      if (side == Sign::negative) beyond = i;
      if (side != Sign::zero) continue;
      ++edges_through;
      on_edge = i;
      edge_sum += i;
    }
    if (beyond >= 0) {
      const std::uint32_t next = f.n[static_cast<std::size_t>(beyond)];
      if (next == kNone) return {};
      last_ = next;
      continue;
    }
    if (edges_through == 0) return {Location::Kind::inside, last_, 0};
    if (edges_through == 1) return {Location::Kind::on_edge, last_, on_edge};
    return {Location::Kind::on_vertex, last_, 3 - edge_sum};  // the corner on both edges
  }
}

}  // namespace cover
