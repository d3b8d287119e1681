// With d = v - u, n its left normal and c, s the cosine and sine of nu, the arc is the curve
//     X(r) = u + (r (c d + s n) + r^2 d) / (1 + 2 r c + r^2),
// the conic with control points u, the meeting point of the tangents, and v, and weights 1, c, 1.
// Its equation is s (u-X).(v-X) + c (u-X)x(v-X) = 0, which says that the angle at X is pi - nu.
// Both stay well scaled for nu from 0 to pi/3.
// Tested by tests/unit/almond/almond_test.cpp.
#include "almond/almond.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/team.hpp"
#include "geom/predicates.hpp"
#include "geom/ulp.hpp"
#include "region/region_boundary.hpp"

namespace cover {
namespace {

/// Spacing of doubles as large as the larger of two.
double spacing(double x, double y) { return spacing_at(std::max(std::abs(x), std::abs(y))); }

}  // namespace

void Almond::set_nu(double value) {
  nu = value;
  sin_nu = std::sin(value);
  cos_nu = std::cos(value);
}

double Almond::power(Point x) const {
  const Vector a = x - from, b = x - to;
  // Twice the area, from the nearer end: the smaller factor makes the smaller error.
  const double area = squared_length(a) < squared_length(b) ? cross(chord(), a) : cross(chord(), b);
  return sin_nu * dot(a, b) + cos_nu * area;
}

double Almond::power_slope(Point x, Vector d) const {
  return sin_nu * dot(d, (x - from) + (x - to)) - cos_nu * cross(d, chord());
}

Point Almond::at_ratio(double r) const {
  const Vector d = chord(), along = cos_nu * d, up = sin_nu * left_normal(d);
  if (r <= 1) return from + 1 / (1 + 2 * r * cos_nu + r * r) * (r * (along + up) + r * r * d);
  const double q = 1 / r;
  return to + 1 / (1 + 2 * q * cos_nu + q * q) * (q * (up + -1.0 * along) + -q * q * d);
}

Point Almond::at_place(double s) const {
  if (s == 0.5) return at_ratio(1);  // exactly half way, so that mirror images agree
  return at_ratio(nu == 0 ? s / (1 - s) : std::sin(s * nu) / std::sin((1 - s) * nu));
}

double Almond::place_of_ratio(double r) const {
  if (r > 1) return 1 - place_of_ratio(1 / r);  // finite at v, where r is infinite
  if (nu == 0) return r / (1 + r);
  return std::atan2(r * sin_nu, 1 + r * cos_nu) / nu;
}

double Almond::height() const { return length / 2 * std::tan(nu / 2); }

std::vector<Almond> make_almonds(const Triangulation& cdt, std::span<const IndexPair> sides,
                                 std::span<const SegmentId> segments, const AngleLimit& limit,
                                 Point origin, const Team& team) {
  std::vector<Almond> almonds(sides.size());
  const auto make = [&](std::size_t k) {
    Almond& a = almonds[k];
    a.u = sides[k][0];
    a.v = sides[k][1];
    a.base = limit.at[k];
    a.apex = cdt.triangles[a.base.triangle].v[a.base.edge];
    a.from = cdt.points[a.u];
    a.to = cdt.points[a.v];
    const Vector chord = a.chord();
    a.length = length(chord);
    a.resolution = (std::abs(chord.y) * spacing(a.from.x + origin.x, a.to.x + origin.x) +
                    std::abs(chord.x) * spacing(a.from.y + origin.y, a.to.y + origin.y)) /
                   a.length;
    if (segments[k] == kHullSide) {
      a.kind = AlmondKind::hull_side;
      return;
    }
    a.apex_limits = compare_with_120_degrees(a.from, cdt.points[a.apex], a.to) != Sign::negative;
    a.set_nu(a.apex_limits ? limit.side_nu[k] : std::numbers::pi / 3);
  };
  team.each_range(sides.size(), kFewAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) make(k);
  });
  return almonds;
}

}  // namespace cover
