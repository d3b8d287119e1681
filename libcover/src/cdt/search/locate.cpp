// A stochastic visibility walk: from triangle to triangle across an edge that has the point beyond
// it. In a triangulation that is not Delaunay (a constrained one need not be) a walk that always
// tries the edges in the same order may go round for ever; starting with a random edge it ends with
// probability 1. The generator is our own, so that the walk is the same everywhere.
// Ref: O. Devillers, S. Pion, M. Teillaud, Walking in a triangulation, IJFCS 13 (2002).
// Tested by tests/unit/cdt/search/locate_test.cpp.
#include "cdt/search/locate.hpp"

#include <optional>

#include "geom/predicates.hpp"

namespace cover {

Location Locator::locate(Point p) {
  const auto& triangles = triangulation_.triangles;
  const auto& points = triangulation_.points;
  if (triangles.empty()) return {};
  for (;;) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;  // Knuth's MMIX generator
    const Triangle& f = triangles[last_];
    auto i = Corner(static_cast<std::uint32_t>((state_ >> 33) % 3));
    Corner on_edge;
    std::uint32_t edges_through = 0, edge_sum = 0;
    std::optional<Corner> beyond;
    for (int k = 0; k < 3 && !beyond; ++k, i = i.next()) {
      const Sign side = orientation(points[f.v[i.next()]], points[f.v[i.previous()]], p);
      if (side == Sign::negative) beyond = i;
      if (side != Sign::zero) continue;
      ++edges_through;
      on_edge = i;
      edge_sum += i;
    }
    if (beyond) {
      const std::uint32_t next = f.n[*beyond];
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
