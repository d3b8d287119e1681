// On the arc of `a`, a rational quadratic in the ratio r, the power with respect to `b` is, up to a
// positive factor, b0 + 2 b1 r + b2 r^2: on circle `a` it is linear (the pencil of the two circles
// contains their radical line), so three control values define it, and no centre is needed.
// A common vertex known by identity is a root known exactly; then the other root follows without a
// square root (in geometry: the mirror image in the line of centres).
// Tested by tests/unit/almond/arc_meeting_test.cpp.
#include "almond/arc_meeting.hpp"

#include <algorithm>
#include <cmath>

namespace cover {
namespace {

/// Width of overlap, relative to the arc, below which two arcs only touch: the place of a double
/// root is known to the square root of the rounding error.
constexpr double kTouch = 0x1p-20;

/// Roots of b0 + 2 b1 r + b2 r^2 = 0 in (0, infinity), at most two.
struct Roots {
  std::array<double, 2> r{};
  int count = 0;
  void add(double x) {
    if (x > 0 && std::isfinite(x)) r[static_cast<std::size_t>(count++)] = x;
  }
};

Roots solve(double b0, double b1, double b2) {
  Roots roots;
  const double discriminant = b1 * b1 - b0 * b2;
  if (std::abs(discriminant) <= kTouch * kTouch * b1 * b1) {
    roots.add(-b1 / b2);
  } else if (discriminant > 0) {
    const double q = -(b1 + std::copysign(std::sqrt(discriminant), b1));
    roots.add(q / b2);
    roots.add(b0 / q);
  }
  return roots;
}

/// The root other than that of a common vertex with ratio `known`.
Roots solve_other(double b0, double b1, double b2, double known) {
  Roots roots;
  if (known == 0) {
    roots.add(-2 * b1 / b2);
  } else if (std::isinf(known)) {
    roots.add(-b0 / (2 * b1));
  } else {
    roots.add(b0 / (b2 * known));
  }
  return roots;
}

}  // namespace

Meetings meet(const Almond& a, std::span<const KnownVertex> known_a, const Almond& b,
              std::span<const KnownVertex> known_b) {
  if (b.length < a.length) {  // the ratio on the shorter side is the more accurate one
    Meetings meetings = meet(b, known_b, a, known_a);
    for (Meeting& m : meetings.item) std::swap(m.place_a, m.place_b);
    return meetings;
  }
  const auto is_known = [&](std::uint32_t vertex) {
    return std::any_of(known_b.begin(), known_b.end(),
                       [&](const KnownVertex& k) { return k.vertex == vertex; });
  };
  int common = 0;
  KnownVertex shared;
  for (const KnownVertex& k : known_a) {
    if (is_known(k.vertex)) {
      ++common;
      shared = k;
    }
  }
  if (common >= 2) return {};

  const Point tangents_meet =
      a.from + 0.5 * (a.chord() + a.sin_nu / a.cos_nu * left_normal(a.chord()));
  const double b0 = is_known(a.u) ? 0 : b.power(a.from);
  const double b2 = is_known(a.v) ? 0 : b.power(a.to);
  const double b1 =
      a.cos_nu * b.power(tangents_meet) - b.sin_nu * squared_length(a.chord()) / (4 * a.cos_nu);
  Roots roots = common == 1 ? solve_other(b0, b1, b2, shared.ratio) : solve(b0, b1, b2);
  // A common vertex some units in the last place beside an end of `a` has a ratio without digits.
  if (common == 1 && roots.count == 1 &&
      std::abs(b.power(a.at_ratio(roots.r[0]))) > kTouch * squared_length(b.chord()))
    roots = solve(b0, b1, b2);

  Meetings meetings;
  for (int i = 0; i < roots.count; ++i) {
    const double r = roots.r[static_cast<std::size_t>(i)];
    const Point x = a.at_ratio(r);
    if (!b.on_the_arc(x)) continue;
    const double place_a = a.place_of_ratio(r);
    if (common == 1 && std::abs(place_a - a.place_of_ratio(shared.ratio)) < kTouch) continue;
    meetings.item[static_cast<std::size_t>(meetings.count++)] = {x, place_a,
                                                                 b.place_of_ratio(b.ratio_of(x))};
  }
  return meetings;
}

}  // namespace cover
