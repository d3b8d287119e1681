// Tested by tests/unit/cuts/before_meshing/split_interfaces_test.cpp.
#include "cuts/before_meshing/narrow_strips.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cuts/before_meshing/least_pieces.hpp"
#include "cuts/room_on_segment.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// A strip is narrow if it is no wider than this part of the edge length wished along it.
constexpr double kThin = 0.5;

/// So many sides at a vertex are the corners of strips, more are spokes.
constexpr std::size_t kMostSides = 8;

using SidesByVertex = std::vector<std::vector<std::uint32_t>>;

SidesByVertex sides_by_vertex(const RegionBoundary& boundary) {
  SidesByVertex sides(boundary.points.size());
  for (std::uint32_t s = 0; s < boundary.sides.size(); ++s) {
    if (boundary.segments[s] == kHullSide) continue;
    for (const std::uint32_t v : boundary.sides[s]) sides[v].push_back(s);
  }
  for (std::vector<std::uint32_t>& at_vertex : sides)
    if (at_vertex.size() > kMostSides) at_vertex.clear();
  return sides;
}

/// Whether `p` lies beside the segment from `a` to `b`, nearer than a narrow strip would be wide.
bool may_face(Point a, Point b, Point p) {
  const double part = part_on_line(a, b, p);
  return part > 0 && part < 1 && length(p - at_part(a, b, part)) < kThin * length(b - a);
}

}  // namespace

void look_across(const RegionBoundary& boundary, const Triangulation& cdt, const AngleLimit& limit,
                 std::vector<Facing>& facing) {
  const SidesByVertex sides_at = sides_by_vertex(boundary);
  const auto of_side = [&](std::uint32_t s) -> Facing& {
    return facing[boundary.segments[s].index()];
  };
  for (const Triangle& t : cdt.triangles) {
    for (const Corner i : kCorners) {
      const Point p = cdt.points[t.v[i.next()]];
      for (const std::uint32_t s : sides_at[t.v[i]]) {
        const auto [a, b] = boundary.sides[s];
        if (may_face(boundary.points[a], boundary.points[b], p)) of_side(s).vertices.push_back(p);
      }
    }
  }
  for (std::uint32_t s = 0; s < boundary.sides.size(); ++s) {
    if (boundary.segments[s] == kHullSide) continue;
    const EdgeRef& edge = limit.at[s];
    for (const std::uint32_t other : sides_at[cdt.triangles[edge.triangle].v[edge.edge]])
      of_side(s).segments.push_back(boundary.segments[other]);
  }
}

std::vector<Point> feet_across(Point from, Point to, const Facing& facing,
                               const SegmentSizes& sizes, std::span<const Point> apexes) {
  const auto [a, b] = std::minmax({from, to});  // the same from both ends
  std::vector<std::pair<double, Point>> feet;
  for (const Point& p : facing.vertices) {
    const double part = part_on_line(a, b, p);
    if (!(part > kLeastBesideFoot && part < 1 - kLeastBesideFoot)) continue;
    const Point foot = foot_on(a, b, p);
    if (length(p - foot) <= kThin * sizes.wished_at(part) &&
        has_room_on_segment(a, b, foot, apexes))
      feet.emplace_back(part, foot);
  }
  std::sort(feet.begin(), feet.end());
  std::vector<Point> places;
  double last = 0;
  for (const auto& [part, foot] : feet) {
    if (part - last > kLeastHalf && 1 - part > kLeastHalf) places.push_back(foot), last = part;
  }
  if (to < from) std::reverse(places.begin(), places.end());
  return places;
}

bool lies_across(Point a, Point b, Point facing_a, Point facing_b, double wished) {
  const auto is_near = [&](Point p) {
    return std::abs(cross(b - a, p - a)) <= kThin * wished * length(b - a);
  };
  return is_near(facing_a) && is_near(facing_b);
}

}  // namespace cover
