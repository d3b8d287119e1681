// Cuts are rounded, and with them a side may come to lie on the wrong side of something near it.
// Whatever goes wrong then shows in the triangulation: if nothing crosses and every side has
// triangles of the region on its left only, the region winds once around its inside; and a point
// that jumped over a side has no triangle. Tested by tests/unit/cdt/region_cdt_test.cpp.
#include "cdt/region_cdt.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>

#include <cover/text.hpp>

#include "base/faults/internal_fault.hpp"
#include "cdt/sides.hpp"
#include "geom/predicates.hpp"

namespace cover {
namespace {

std::string side_text(Point a, Point b) { return "from " + describe(a) + " to " + describe(b); }

/// The flaw at the points with these indices.
Flaw flaw_at(std::string what, std::span<const Point> points, std::vector<std::uint32_t> indices) {
  Flaw flaw{std::move(what), {}, std::move(indices)};
  for (const std::uint32_t v : flaw.points) flaw.where.push_back(points[v]);
  return flaw;
}

Flaw describe_conflict(const CdtConflict& conflict, std::span<const Point> points,
                       std::span<const IndexPair> sides) {
  const auto [p, other] = std::pair(conflict.first, conflict.second);
  const auto text = [&](std::uint32_t s) {
    return side_text(points[sides[s][0]], points[sides[s][1]]);
  };
  switch (conflict.kind) {
    case CdtConflict::Kind::duplicate_point:
      return flaw_at("two points have the same coordinates " + describe(points[p]), points,
                     {p, other});
    case CdtConflict::Kind::point_on_segment:
      return flaw_at("the point " + describe(points[p]) + " lies on the side " + text(other),
                     points, {p, sides[other][0], sides[other][1]});
    case CdtConflict::Kind::crossing:
      break;
  }
  return flaw_at("the sides " + text(p) + " and " + text(other) + " cross", points,
                 {sides[p][0], sides[p][1], sides[other][0], sides[other][1]});
}

/// A triangle on the right of a side that is no slit: across the edge, or none.
bool has_right(const Triangulation& cdt, EdgeRef at) {
  return cdt.triangles[at.triangle].n[at.edge] != kNone;
}

/// Triangles with what lies across their edges, and the sides among these.
class Assembly {
 public:
  /// REQUIRES: corners below points.size(); no two triangles have the same directed edge; `sides`
  ///           in lexicographic order
  Assembly(std::span<const Point> points, std::span<const IndexPair> sides,
           std::span<const IndexTriple> triangles, const Team& team)
      : sides_(sides),
        triangles_(triangles),
        team_(team),
        opposite_(opposite_half_edges(points.size(), triangles, team)),
        first_side_(points.size() + 1, 0) {
    for (const IndexPair& side : sides) ++first_side_[side[0] + 1];
    for (std::size_t v = 1; v < first_side_.size(); ++v) first_side_[v] += first_side_[v - 1];
    out_.points.assign(points.begin(), points.end());
    out_.triangles.resize(triangles.size());
    team.each_range(triangles.size(), kItemsAtATime, [this](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) fill(t);
    });
  }

  /// Whether no other triangles fill the sides and are constrained Delaunay.
  [[nodiscard]] bool is_the_only_one() const {
    std::vector<std::uint8_t> is_used(out_.points.size(), 0);
    for (const IndexTriple& t : triangles_)
      for (const std::uint32_t v : t) is_used[v] = 1;
    if (std::find(is_used.begin(), is_used.end(), 0) != is_used.end()) return false;
    std::atomic<std::size_t> sides = 0;
    std::atomic<bool> is_good = true;
    team_.each_range(triangles_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      std::size_t own = 0;
      for (std::size_t t = first; t < last && is_good; ++t)
        if (!is_good_triangle(static_cast<std::uint32_t>(t), own)) is_good = false;
      sides += own;
    });
    return is_good && sides == sides_.size();
  }

  Triangulation take() { return std::move(out_); }

 private:
  [[nodiscard]] bool is_side(std::uint32_t u, std::uint32_t v) const {
    return std::binary_search(sides_.begin() + first_side_[u], sides_.begin() + first_side_[u + 1],
                              IndexPair{u, v});
  }

  void fill(std::size_t t) {
    Triangle& triangle = out_.triangles[t];
    triangle.v = triangles_[t];
    for (const Corner i : kCorners) {  // half-edge i starts at corner i: opposite to i + 2
      const Corner edge = i.previous();
      const std::uint32_t u = triangle.v[i], v = triangle.v[i.next()];
      const std::uint32_t twin = opposite_[3 * t + i];
      triangle.n[edge] = twin == kNone ? kNone : twin / 3;
      if (is_side(u, v) || is_side(v, u)) triangle.set_locked(edge, true);
    }
  }

  /// Counts the sides among its edges.
  [[nodiscard]] bool is_good_triangle(std::uint32_t t, std::size_t& sides) const {
    const Triangle& own = out_.triangles[t];
    const auto& points = out_.points;
    const Point a = points[own.v[0]], b = points[own.v[1]], c = points[own.v[2]];
    if (orientation(a, b, c) != Sign::positive) return false;
    for (const Corner i : kCorners) {
      const std::uint32_t n = own.n[i];
      if (own.is_locked(i)) {
        // A triangle on the right of a side is there for a slit alone, which is a side both ways.
        const std::uint32_t u = own.v[i.next()], v = own.v[i.previous()];
        if (!is_side(u, v) || (n != kNone && !is_side(v, u))) return false;
        ++sides;
      } else if (n == kNone) {
        return false;
      } else if (n > t) {
        const Triangle& other = out_.triangles[n];
        const Point beyond = points[other.v[other.edge_to(t)]];
        if (in_circle(a, b, c, beyond) != Sign::negative) return false;
      }
    }
    return true;
  }

  std::span<const IndexPair> sides_;
  std::span<const IndexTriple> triangles_;
  const Team& team_;
  std::vector<std::uint32_t> opposite_;
  std::vector<std::uint32_t> first_side_;  ///< by point, into sides_
  Triangulation out_;
};

/// In the order in which points were inserted.
Triangulation as_made(std::span<const Point> points, std::span<const IndexPair> sides) {
  CdtResult cdt = triangulate_domain(points, sides);
  if (auto flaw = find_flaw(cdt, points, sides))
    throw InternalFault(flaw->what, std::move(flaw->where));
  return std::move(cdt.triangulation);
}

bool are_corners(std::span<const IndexTriple> triangles, std::size_t points) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const IndexTriple& t) {
    return std::max({t[0], t[1], t[2]}) < points;
  });
}

}  // namespace

std::optional<Flaw> find_flaw(const CdtResult& cdt, std::span<const Point> points,
                              std::span<const IndexPair> sides) {
  if (!cdt.conflicts.empty()) return describe_conflict(cdt.conflicts.front(), points, sides);
  const Triangulation& triangulation = cdt.triangulation;
  const std::vector<EdgeRef> at = locate_sides(triangulation, sides);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto& [u, v] = sides[s];
    if (at[s].triangle != kNone &&
        (!has_right(triangulation, at[s]) ||
         std::binary_search(sides.begin(), sides.end(), IndexPair{v, u})))
      continue;
    const char* const what =
        at[s].triangle == kNone ? " has no triangle on its left" : " has a triangle on its right";
    return flaw_at("the side " + side_text(points[u], points[v]) + what, points, {u, v});
  }
  std::vector<bool> used(points.size(), false);
  for (const Triangle& t : triangulation.triangles) {
    for (const std::uint32_t v : t.v) used[v] = true;
  }
  const auto lost = std::find(used.begin(), used.end(), false);
  if (lost == used.end()) return std::nullopt;
  const auto p = static_cast<std::uint32_t>(lost - used.begin());
  return flaw_at("the point " + describe(points[p]) + " does not lie in the region", points, {p});
}

void put_in_order(std::size_t points, std::vector<IndexTriple>& triangles, const Team& team) {
  std::vector<std::uint32_t> next(points + 1, 0);
  team.each_range(triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      IndexTriple& t = triangles[k];
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    }
  });
  for (const IndexTriple& t : triangles) ++next[t[0] + 1];
  for (std::size_t v = 1; v < next.size(); ++v) next[v] += next[v - 1];
  std::vector<IndexTriple> sorted(triangles.size());
  for (const IndexTriple& t : triangles) sorted[next[t[0]]++] = t;
  triangles = std::move(sorted);
  team.each_range(points, kItemsAtATime, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {  // next[v] is where v + 1 begins
      const auto first = static_cast<std::ptrdiff_t>(v == 0 ? 0 : next[v - 1]);
      std::sort(triangles.begin() + first, triangles.begin() + next[v]);
    }
  });
}

Triangulation triangulate_region(std::span<const Point> points, std::span<const IndexPair> sides,
                                 std::span<const IndexTriple> known, const Team& team) {
  const bool is_middling = points.size() > kSmallRegion && points.size() < kLargeRegion;
  return is_middling ? as_made(points, sides) : triangulate_in_order(points, sides, known, team);
}

Triangulation triangulate_in_order(std::span<const Point> points, std::span<const IndexPair> sides,
                                   std::span<const IndexTriple> known, const Team& team) {
  if (!known.empty() && are_corners(known, points.size())) {
    Assembly assembly(points, sides, known, team);
    if (assembly.is_the_only_one()) return assembly.take();
  }
  std::vector<IndexTriple> triangles;
  for (const Triangulation made = as_made(points, sides); const Triangle& t : made.triangles)
    triangles.push_back(t.v);
  put_in_order(points.size(), triangles, team);
  return Assembly(points, sides, triangles, team).take();
}

}  // namespace cover
