// Tested by tests/unit/verify/verify_test.cpp.
#include "verify/verify_boxes.hpp"

#include <algorithm>

#include "geom/angle_rounding.hpp"

namespace cover {
namespace {

bool is_obtuse(Point a, Point p, Point b) {
  return compare_with_90_degrees(a, p, b) == Sign::positive;
}

}  // namespace

BoxCheck verify_boxes(const TriangleSoup& mesh, const SoupEdges& edges,
                      std::span<const std::uint32_t> side_of, const ExpectedDomain& domain,
                      std::span<const RegionId> region, std::span<const Point> points) {
  using Kind = NegativeCoupling::Kind;
  const auto all = edges.all();
  const auto corner_beyond = [&](const SoupEdges::Edge& e) {
    const auto& t = mesh.triangles[e.triangle];
    const auto other =
        std::find_if(t.begin(), t.end(), [&](auto v) { return v != e.from && v != e.to; });
    return mesh.points[*other];
  };
  BoxCheck check;
  const double farthest = largest_coordinate(mesh.points);
  std::vector<NegativeCoupling> on_sides;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const SoupEdges::Edge& e = all[k];
    if (e.from == mesh.triangles[e.triangle][0]) {  // once per triangle
      const auto& t = mesh.triangles[e.triangle];
      const Point p = mesh.points[t[0]], q = mesh.points[t[1]], r = mesh.points[t[2]];
      const Blunt blunt = std::max({bluntness(p, q, r, farthest), bluntness(q, r, p, farthest),
                                    bluntness(r, p, q, farthest)});
      check.obtuse += blunt != Blunt::no ? 1 : 0;
      check.obtuse_by_rounding += blunt == Blunt::by_rounding ? 1 : 0;
    }
    const Point a = mesh.points[e.from], b = mesh.points[e.to], c = corner_beyond(e);
    if (side_of[k] != kNoSide) {
      if (!is_obtuse(a, c, b)) continue;
      const ExpectedSide& side = domain.sides[side_of[k]];
      const Point by = points[side.apex];
      const bool is_encroached = is_obtuse(a, by, b);
      on_sides.push_back({is_encroached ? Kind::encroached : Kind::given_up, region[e.triangle], a,
                          b, is_encroached ? by : c});
      continue;
    }
    const auto twin = edges.find(e.to, e.from);
    if (!twin || e.to < e.from) continue;
    if (in_circle(a, b, c, corner_beyond(all[*twin])) == Sign::positive)
      check.negative.push_back({Kind::inside, region[e.triangle], a, b, c});
  }
  check.negative.insert(check.negative.end(), on_sides.begin(), on_sides.end());
  return check;
}

}  // namespace cover
