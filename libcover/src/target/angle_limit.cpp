// Nothing but a pass over the sides. The care goes into nu of flat triangles: with a gap of 1e-9
// the cross product of rounded differences keeps 7 digits, so there the differences are taken with
// their rounding errors and the 2x2 determinant by fused multiply-add (Kahan).
// Tested by tests/unit/target/angle_limit_test.cpp.
#include "target/angle_limit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geom/angle_rounding.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "region/region_boundary.hpp"

namespace cover {
namespace {

/// high + low is exactly a - b.
struct Difference {
  double high, low;
  Difference(double a, double b) : high(a - b) {
    const double b_part = a - high, a_part = high + b_part;
    low = (a - a_part) - (b - b_part);
  }
};

/// p q - r s with a relative error of 2^-52.
double determinant(double p, double q, double r, double s) {
  const double rs = r * s;
  return std::fma(p, q, -rs) + std::fma(-r, s, rs);
}

}  // namespace

double accurate_nu_at(Point a, Point p, Point b) {
  const Difference ux(a.x, p.x), uy(a.y, p.y), vx(b.x, p.x), vy(b.y, p.y);
  const double cross =
      determinant(ux.high, vy.high, uy.high, vx.high) +
      ((ux.high * vy.low - uy.high * vx.low) + (ux.low * vy.high - uy.low * vx.high));
  return std::atan2(std::abs(cross), -(ux.high * vx.high + uy.high * vy.high));
}

double AngleLimit::promised_nu() const { return cover::promised_nu(nu); }

AngleLimit angle_limit(const Triangulation& cdt, std::span<const IndexPair> sides,
                       std::span<const SegmentId> segments, const Team& team) {
  AngleLimit limit;
  limit.at = locate_sides(cdt, sides, team);
  limit.side_nu.assign(sides.size(), std::numbers::pi);
  std::vector<std::size_t> above_120(Team::ranges(sides.size(), kItemsAtATime), 0);
  team.each_range(sides.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t s = first; s < last; ++s) {
      if (segments[s] == kHullSide || limit.at[s].triangle == kNone) continue;
      const Point u = cdt.points[sides[s][0]], v = cdt.points[sides[s][1]];
      const Point apex = cdt.points[cdt.triangles[limit.at[s].triangle].v[limit.at[s].edge]];
      limit.side_nu[s] = accurate_nu_at(u, apex, v);
      if (compare_with_120_degrees(u, apex, v) == Sign::positive)
        ++above_120[first / kItemsAtATime];
    }
  });
  limit.above_120 = std::accumulate(above_120.begin(), above_120.end(), std::size_t{0});
  for (std::size_t s = 0; s < sides.size(); ++s) {
    if (limit.side_nu[s] < std::numbers::pi / 6) ++limit.above_150;
    limit.nu = std::min(limit.nu, limit.side_nu[s]);
  }
  return limit;
}

}  // namespace cover
