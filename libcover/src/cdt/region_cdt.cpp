// Cuts are rounded, and with them a side may come to lie on the wrong side of something near it.
// Whatever goes wrong then shows in the triangulation: if nothing crosses and every side has
// triangles of the region on its left only, the region winds once around its inside; and a point
// that jumped over a side has no triangle. Tested by tests/unit/cdt/region_cdt_test.cpp.
#include "cdt/region_cdt.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <cover/text.hpp>

#include "base/faults/internal_fault.hpp"
#include "cdt/sides.hpp"

namespace cover {
namespace {

std::string side_text(Point a, Point b) { return "from " + describe(a) + " to " + describe(b); }

/// The fault at the points with these indices.
BoundaryFault fault_at(std::string what, std::span<const Point> points,
                       std::vector<std::uint32_t> indices) {
  BoundaryFault fault{std::move(what), {}, std::move(indices)};
  for (const std::uint32_t v : fault.points) fault.where.push_back(points[v]);
  return fault;
}

BoundaryFault describe_conflict(const CdtConflict& conflict, std::span<const Point> points,
                                std::span<const IndexPair> sides) {
  const auto [p, other] = std::pair(conflict.first, conflict.second);
  const auto text = [&](std::uint32_t s) {
    return side_text(points[sides[s][0]], points[sides[s][1]]);
  };
  switch (conflict.kind) {
    case CdtConflict::Kind::duplicate_point:
      return fault_at("two points have the same coordinates " + describe(points[p]), points,
                      {p, other});
    case CdtConflict::Kind::point_on_segment:
      return fault_at("the point " + describe(points[p]) + " lies on the side " + text(other),
                      points, {p, sides[other][0], sides[other][1]});
    case CdtConflict::Kind::crossing:
      break;
  }
  return fault_at("the sides " + text(p) + " and " + text(other) + " cross", points,
                  {sides[p][0], sides[p][1], sides[other][0], sides[other][1]});
}

/// A triangle on the right of a side that is no slit: across the edge, or none.
bool has_right(const Triangulation& cdt, EdgeRef at) {
  return cdt.triangles[at.triangle].n[at.edge] != kNone;
}

}  // namespace

std::optional<BoundaryFault> find_fault(const CdtResult& cdt, std::span<const Point> points,
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
    return fault_at("the side " + side_text(points[u], points[v]) + what, points, {u, v});
  }
  std::vector<bool> used(points.size(), false);
  for (const Triangle& t : triangulation.triangles) {
    for (const std::uint32_t v : t.v) used[v] = true;
  }
  const auto lost = std::find(used.begin(), used.end(), false);
  if (lost == used.end()) return std::nullopt;
  const auto p = static_cast<std::uint32_t>(lost - used.begin());
  return fault_at("the point " + describe(points[p]) + " does not lie in the region", points, {p});
}

Triangulation triangulate_region(std::span<const Point> points, std::span<const IndexPair> sides) {
  CdtResult cdt = triangulate_domain(points, sides);
  if (auto fault = find_fault(cdt, points, sides))
    throw InternalFault(fault->what, std::move(fault->where));
  return std::move(cdt.triangulation);
}

}  // namespace cover
