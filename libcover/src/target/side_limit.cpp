// The smallest angle: let T(x) be the triangle on the side UV with angles x at U and V. A triangle
// on UV whose angles at U and V are both at least x contains T(x). So where T(x) cannot be had,
// every triangle on UV has an angle below x. T(x) cannot be had where a side crosses the
// perpendicular bisector of UV below its apex: we walk up the bisector through the triangulation
// until we meet one. (Vertices in T(x) need no look: up to pi - 2x >= gamma_opt it lies in the
// circle of the Delaunay triangle on UV, where none is in sight. Beyond that the largest angle is
// forced as well.)
// Tested by tests/unit/target/side_limit_test.cpp.
#include "target/side_limit.hpp"

#include <algorithm>
#include <cmath>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "target/goal.hpp"

namespace cover {
namespace {

constexpr double kHighEnough = 0.5;  ///< times the side: there x is 45 degrees

/// The height at which the perpendicular bisector of `side` meets another one, in lengths of the
/// side; kHighEnough if it does not below that.
double free_height(const Triangulation& cdt, EdgeRef side) {
  const auto corner = [&](std::uint32_t t, Corner i) { return cdt.points[cdt.triangles[t].v[i]]; };
  std::uint32_t t = side.triangle;
  Corner entry = side.edge;
  const Point u = corner(t, entry.next()), v = corner(t, entry.previous());
  const Point middle = midpoint(u, v);
  const Vector along = v - u, up = left_normal(along);
  for (;;) {
    const bool apex_is_right = dot(corner(t, entry) - middle, along) > 0;
    const Corner exit = apex_is_right ? entry.previous() : entry.next();
    const Vector a = corner(t, exit.next()) - middle, b = corner(t, exit.previous()) - middle;
    const double share = dot(a, along) / (dot(a, along) - dot(b, along));
    const double height = (dot(a, up) + share * dot(b - a, up)) / squared_length(along);
    if (!(height < kHighEnough)) return kHighEnough;
    const std::uint32_t next = cdt.triangles[t].n[exit];
    if (next == kNone || cdt.triangles[t].is_locked(exit)) return height;
    entry = cdt.triangles[next].edge_to(t);
    t = next;
  }
}

bool is_boundary(const Triangulation& cdt, std::uint32_t t, Corner i) {
  return cdt.triangles[t].n[i] == kNone || cdt.triangles[t].is_locked(i);
}

/// The limit of the corner at the end of `side`, or at its start: we turn around it through the
/// triangulation until we meet the next side. None from a right angle on.
CornerLimit corner_limit(const Triangulation& cdt, EdgeRef side, bool at_end) {
  const auto corner = [&](std::uint32_t t, Corner i) { return cdt.points[cdt.triangles[t].v[i]]; };
  std::uint32_t t = side.triangle;
  Corner entry = side.edge;
  const Point p = corner(t, at_end ? entry.previous() : entry.next());
  const Point first = corner(t, at_end ? entry.next() : entry.previous());
  Point last = corner(t, entry);
  for (;;) {
    if (dot(first - p, last - p) <= 0) return {};
    const Corner exit = at_end ? entry.next() : entry.previous();
    if (is_boundary(cdt, t, exit)) break;
    const std::uint32_t beyond = cdt.triangles[t].n[exit];
    entry = cdt.triangles[beyond].edge_to(t);
    t = beyond;
    last = corner(t, entry);
  }
  const Corners k = at_end ? Corners(p, last, first) : Corners(p, first, last);
  if (!(k.cross > 0)) return {};
  const double cot = k.dot[0] / k.cross;
  return {cot + std::sqrt(1 + cot * cot), -std::min({k.dot[0], k.dot[1], k.dot[2]}) / k.cross,
          std::max(k.dot[1], k.dot[2]) / k.cross};
}

}  // namespace

void mind_free_sides(const Triangulation& cdt, std::span<const EdgeRef> side_at,
                     std::span<SideLimit> limits, const Team& team) {
  team.each_range(side_at.size(), kFewAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t s = first; s < last; ++s) {
      const auto& v = cdt.triangles[side_at[s].triangle].v;
      const Corner i = side_at[s].edge;
      const Point a = cdt.points[v[i.next()]], b = cdt.points[v[i.previous()]];
      if (compare_with_90_degrees(a, cdt.points[v[i]], b) != Sign::positive)
        limits[s].least_cot = std::min(0.0, limits[s].apex_cot - kSameCot);
    }
  });
}

std::vector<SideLimit> side_limits(const Triangulation& cdt, std::span<const EdgeRef> side_at,
                                   const Team& team) {
  std::vector<SideLimit> limits(side_at.size());
  team.each_range(side_at.size(), kFewAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t s = first; s < last; ++s) {
      const EdgeRef side = side_at[s];
      const auto& v = cdt.triangles[side.triangle].v;
      const Corner i = side.edge;
      const Corners k(cdt.points[v[i]], cdt.points[v[i.next()]], cdt.points[v[i.previous()]]);
      limits[s] = {k.dot[0] / k.cross,
                   std::max({k.dot[0], k.dot[1], k.dot[2]}) / k.cross,
                   1 / (2 * free_height(cdt, side)),
                   {corner_limit(cdt, side, false), corner_limit(cdt, side, true)}};
    }
  });
  return limits;
}

}  // namespace cover
