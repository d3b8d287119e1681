// The hull of a convex set leaves a vertex once, so the piece on which a split side begins is the
// one edge on the outside that leaves the start of the side and is no side itself.
// Tested by tests/unit/quality/mutable/split_hull_test.cpp.
#include "quality/mutable/split_hull.hpp"

#include <algorithm>
#include <utility>

namespace cover {
namespace {

/// The edges on the outside that are no sides.
std::vector<EdgeRef> pieces_of_hull(const Triangulation& triangles,
                                    const std::vector<EdgeRef>& sides) {
  std::vector<std::uint8_t> is_side(triangles.triangles.size(), 0);
  for (const EdgeRef& side : sides) {
    if (side.triangle != kNone)
      is_side[side.triangle] = static_cast<std::uint8_t>(is_side[side.triangle] | 1U << side.edge);
  }
  std::vector<EdgeRef> pieces;
  for (std::uint32_t t = 0; t < triangles.triangles.size(); ++t) {
    for (std::uint8_t i = 0; i < 3; ++i) {
      if (triangles.triangles[t].n[i] == kNone && (is_side[t] >> i & 1) == 0)
        pieces.push_back({t, i});
    }
  }
  return pieces;
}

/// The ends of an edge, with its triangle on the left.
IndexPair ends_of(const Triangulation& triangles, EdgeRef edge) {
  const auto& v = triangles.triangles[edge.triangle].v;
  return {v[edge.edge.next()], v[edge.edge.previous()]};
}

/// Puts the ends of `pieces` behind the first `fixed` points, and returns how many stay in place.
std::uint32_t put_first(Triangulation& triangles, const std::vector<EdgeRef>& pieces,
                        std::uint32_t fixed) {
  std::vector<std::uint32_t> number(triangles.points.size(), kNone);
  std::vector<Point> points(triangles.points.begin(), triangles.points.begin() + fixed);
  for (std::uint32_t v = 0; v < fixed; ++v) number[v] = v;
  const auto put = [&](std::uint32_t v) {
    if (number[v] != kNone) return;
    number[v] = static_cast<std::uint32_t>(points.size());
    points.push_back(triangles.points[v]);
  };
  for (const EdgeRef& piece : pieces) {
    for (const std::uint32_t v : ends_of(triangles, piece)) put(v);
  }
  const auto first_free = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t v = fixed; v < number.size(); ++v) put(v);
  triangles.points = std::move(points);
  for (Triangle& t : triangles.triangles) {
    for (std::uint32_t& v : t.v) v = number[v];
  }
  return first_free;
}

}  // namespace

SplitSides locate_split_sides(Triangulation& triangles, const RegionBoundary& boundary) {
  SplitSides out;
  out.fixed = static_cast<std::uint32_t>(boundary.points.size());
  out.at = locate_sides(triangles, boundary.sides);
  const bool is_whole = std::all_of(out.at.begin(), out.at.end(),
                                    [](const EdgeRef& at) { return at.triangle != kNone; });
  if (is_whole) return out;
  const std::vector<EdgeRef> pieces = pieces_of_hull(triangles, out.at);
  out.fixed = put_first(triangles, pieces, out.fixed);
  std::vector<std::pair<std::uint32_t, EdgeRef>> from;  // by the vertex that the piece leaves
  for (const EdgeRef& piece : pieces) from.emplace_back(ends_of(triangles, piece)[0], piece);
  std::sort(from.begin(), from.end(),
            [](const auto& x, const auto& y) { return x.first < y.first; });
  for (std::uint32_t s = 0; s < boundary.sides.size(); ++s) {
    if (out.at[s].triangle != kNone || boundary.segments[s] != kHullSide) continue;
    const auto first = std::lower_bound(from.begin(), from.end(), boundary.sides[s][0],
                                        [](const auto& x, std::uint32_t v) { return x.first < v; });
    if (first == from.end() || first->first != boundary.sides[s][0]) continue;
    out.at[s] = first->second;
    out.split.push_back(s);
    from.erase(first);
  }
  for (const auto& [start, piece] : from) out.at.push_back(piece);
  return out;
}

}  // namespace cover
