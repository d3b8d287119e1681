// See tell_couplings.hpp. Tested by tests/unit/quality/promise_7_test.cpp and
// tests/unit/mend/couplings/delaunay_within_bound_test.cpp.
#include "target/report/tell_couplings.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/none.hpp"
#include "box/encroached_sides.hpp"
#include "cdt/couplings.hpp"
#include "cdt/region_cdt.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/ulp.hpp"
#include "limits/couplings/forced_sides.hpp"
#include "target/report/sorted_corners.hpp"

namespace cover {
namespace {

/// The triangles of a triangulation that are beyond the bound, by more than rounding.
std::vector<std::array<Point, 3>> triangles_beyond(const Triangulation& cdt, Angle nu_bound) {
  std::vector<std::array<Point, 3>> beyond;
  const double farthest = largest_coordinate(cdt.points);
  for (const Triangle& t : cdt.triangles) {
    const Point a = cdt.points[t.v[0]], b = cdt.points[t.v[1]], c = cdt.points[t.v[2]];
    if (largest_nu_of(a, b, c) + angle_rounding(a, b, c, farthest) < nu_bound.in_radians())
      beyond.push_back({a, b, c});
  }
  return beyond;
}

/// The triangulation of the points of the boundary, and of what else is given.
Triangulation cdt_of_given(const RegionBoundary& boundary, std::span<const Point> given) {
  if (given.size() == boundary.points.size())
    return triangulate_in_order(boundary.points, boundary.sides, boundary.known_triangles());
  return triangulate_domain(given, boundary.sides).triangulation;
}

/// Of the sides that are given up: those that the bound forces.
void find_forced(const RegionBoundary& boundary, Angle nu_bound,
                 std::vector<NegativeCoupling>& couplings) {
  using Kind = NegativeCoupling::Kind;
  const auto is_inside = [](const NegativeCoupling& c) { return c.kind == Kind::inside; };
  if (std::any_of(couplings.begin(), couplings.end(), is_inside) || boundary.has_hull_sides())
    return;
  const Triangulation cdt = cdt_of_given(boundary, boundary.points);
  const std::vector<bool> is_free = free_sides(cdt, locate_sides(cdt, boundary.sides));
  std::vector<NegativeCoupling*> given_up;
  for (NegativeCoupling& c : couplings) {
    if (c.kind == Kind::given_up) given_up.push_back(&c);
  }
  tell_forced(boundary.points, boundary.sides, is_free, triangles_beyond(cdt, nu_bound), given_up);
}
}  // namespace

std::vector<NegativeCoupling> tell_couplings(const RegionBoundary& boundary, const RegionMesh& mesh,
                                             std::span<const Point> points,
                                             const Opposites& opposites, const Team& team,
                                             BoxMethod& box) {
  std::vector<NegativeCoupling> found;
  const std::vector<NegativeEdge> negative =
      negative_edges(points, mesh.triangles, opposites.across, opposites.cots, team);
  // Layers were asked for, so their vertices are as given as those of the boundary.
  const auto given = points.first(boundary.points.size() + mesh.layer_vertices);
  // In a Delaunay mesh it is the apex that sees a side under the largest angle: if it is given, no
  // triangulation of what is given needs to tell who encroaches the side.
  const bool apexes_tell =
      std::all_of(negative.begin(), negative.end(),
                  [&](const NegativeEdge& e) { return e.is_side && e.apex < given.size(); });
  std::vector<std::uint32_t> encroached_by(boundary.sides.size(), kNone);
  if (!apexes_tell) {
    const Triangulation cdt = cdt_of_given(boundary, given);
    for (const EncroachedSide& e : encroached_sides(cdt, locate_sides(cdt, boundary.sides)))
      encroached_by[e.side] = e.vertex;
  }
  for (const NegativeEdge& e : negative) {
    auto kind = NegativeCoupling::Kind::inside;
    Point apex = points[e.apex];
    if (e.is_side) {
      const auto side = std::lower_bound(boundary.sides.begin(), boundary.sides.end(), e.edge);
      // A side of the hull may have been split: its pieces are no sides of the boundary.
      const bool is_whole = side != boundary.sides.end() && *side == e.edge;
      const std::uint32_t by =
          !is_whole     ? kNone
          : apexes_tell ? e.apex
                        : encroached_by[static_cast<std::size_t>(side - boundary.sides.begin())];
      kind = by == kNone ? NegativeCoupling::Kind::given_up : NegativeCoupling::Kind::encroached;
      if (by != kNone) apex = points[by];
    }
    found.push_back({kind, boundary.id, points[e.edge[0]], points[e.edge[1]], apex});
  }
  if (std::any_of(found.begin(), found.end(), [](const NegativeCoupling& c) {
        return c.kind == NegativeCoupling::Kind::given_up;
      }))
    find_forced(boundary, mesh.report.nu_bound, found);
  const auto count = [&](NegativeCoupling::Kind kind) {
    return static_cast<std::size_t>(std::count_if(
        found.begin(), found.end(), [&](const NegativeCoupling& c) { return c.kind == kind; }));
  };
  box.negative_couplings = found.size();
  box.negative_inside = count(NegativeCoupling::Kind::inside);
  box.negative_encroached = count(NegativeCoupling::Kind::encroached);
  box.negative_forced = count(NegativeCoupling::Kind::forced);
  box.negative_given_up = count(NegativeCoupling::Kind::given_up);
  return found;
}

}  // namespace cover
