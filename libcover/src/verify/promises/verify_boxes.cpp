// Tested by tests/unit/verify/verify_test.cpp.
#include "verify/promises/verify_boxes.hpp"

#include <algorithm>
#include <array>

#include "base/containers/order.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/topology/half_edges.hpp"
#include "geom/vector.hpp"
#include "limits/couplings/forced_sides.hpp"

namespace cover {
namespace {

bool is_beyond_right_angle(Point a, Point p, Point b) {
  return compare_with_90_degrees(a, p, b) == Sign::positive;
}

/// The triangles of a region's constrained Delaunay triangulation that are beyond the bound, by
/// more than rounding.
std::vector<std::array<Point, 3>> triangles_beyond(const ExpectedDomain& domain,
                                                   std::span<const Point> points, RegionId region) {
  std::vector<std::array<Point, 3>> beyond;
  const double bound = promised_nu(domain.nu_opt[region.value()]);
  const double farthest = largest_coordinate(points);
  for (std::size_t t = 0; t < domain.cdt.triangles.size(); ++t) {
    if (domain.cdt_region[t] != region) continue;
    const auto& v = domain.cdt.triangles[t].v;
    const Point a = points[v[0]], b = points[v[1]], c = points[v[2]];
    if (least_nu(a, b, c) + angle_rounding(a, b, c, farthest) < bound * kNuRounded)
      beyond.push_back({a, b, c});
  }
  return beyond;
}

/// Of the couplings of one region that are given up: those that the bound forces.
void find_forced(const ExpectedDomain& domain, std::span<const Point> points, RegionId region,
                 std::span<NegativeCoupling> couplings) {
  std::vector<IndexPair> sides;
  std::vector<bool> is_free;
  for (const ExpectedSide& side : domain.sides) {
    if (side.region != region) continue;
    if (side.hull) return;  // it may be split
    sides.push_back({side.a, side.b});
    is_free.push_back(!is_beyond_right_angle(points[side.a], points[side.apex], points[side.b]));
  }
  std::vector<NegativeCoupling*> given_up;
  for (NegativeCoupling& c : couplings) {
    if (c.region == region && c.kind == NegativeCoupling::Kind::given_up) given_up.push_back(&c);
  }
  tell_forced(points, sides, is_free, triangles_beyond(domain, points, region), given_up);
}

/// The same in all regions, but for those with a negative coupling inside: it may be the one that
/// the proof speaks of.
void find_forced(const ExpectedDomain& domain, std::span<const Point> points,
                 std::span<const NegativeCoupling> inside, std::span<NegativeCoupling> on_sides) {
  const auto has_inside = [&](RegionId r) {
    return std::any_of(inside.begin(), inside.end(),
                       [&](const NegativeCoupling& c) { return c.region == r; });
  };
  std::vector<RegionId> told;
  for (const NegativeCoupling& c : on_sides) {
    if (c.kind == NegativeCoupling::Kind::given_up && !has_inside(c.region))
      told.push_back(c.region);
  }
  sort_unique(told);
  for (const RegionId r : told) find_forced(domain, points, r, on_sides);
}

void count_if_obtuse(const TriangleSoup& mesh, const IndexTriple& t, BoxCheck& check) {
  const Blunt blunt = bluntness_of(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  check.obtuse += blunt == Blunt::yes ? 1 : 0;
  check.obtuse_by_rounding += blunt == Blunt::by_rounding ? 1 : 0;
}

Point corner_beyond(const TriangleSoup& mesh, const SoupEdges::Edge& e) {
  const IndexTriple& t = mesh.triangles[e.triangle];
  const auto other =
      std::find_if(t.begin(), t.end(), [&](auto v) { return v != e.from && v != e.to; });
  return mesh.points[*other];
}

}  // namespace

BoxCheck verify_boxes(const TriangleSoup& mesh, const SoupEdges& edges,
                      std::span<const std::uint32_t> side_of, const ExpectedDomain& domain,
                      std::span<const RegionId> region, std::span<const Point> points) {
  using Kind = NegativeCoupling::Kind;
  const auto all = edges.all();
  BoxCheck check;
  std::vector<NegativeCoupling> on_sides;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const SoupEdges::Edge& e = all[k];
    const IndexTriple& triangle = mesh.triangles[e.triangle];
    if (e.from == triangle[0]) count_if_obtuse(mesh, triangle, check);  // once per triangle
    const Point a = mesh.points[e.from], b = mesh.points[e.to], c = corner_beyond(mesh, e);
    if (side_of[k] != kNone) {
      if (!is_beyond_right_angle(a, c, b)) continue;
      const Point by = points[domain.sides[side_of[k]].apex];
      const bool is_encroached = is_beyond_right_angle(a, by, b);
      on_sides.push_back({is_encroached ? Kind::encroached : Kind::given_up, region[e.triangle], a,
                          b, is_encroached ? by : c});
      continue;
    }
    const auto twin = edges.find(e.to, e.from);
    if (!twin || e.to < e.from) continue;
    if (in_circle(a, b, c, corner_beyond(mesh, all[*twin])) == Sign::positive)
      check.negative.push_back({Kind::inside, region[e.triangle], a, b, c});
  }
  find_forced(domain, points, check.negative, on_sides);
  check.negative.insert(check.negative.end(), on_sides.begin(), on_sides.end());
  return check;
}

}  // namespace cover
