// A crossing is first computed with twice the digits of a double and a bound for the error, which
// nearly always tells the nearest double; then comparing roundings nearly always tells the order.
// What is left is decided by rational arithmetic. Tested by tests/unit/geom/sweep_point_test.cpp.
#include "geom/sweep_point.hpp"

#include <CGAL/Exact_rational.h>

#include <cmath>
#include <optional>

#include "geom/double_double.hpp"

namespace cover {
namespace {

using Rational = CGAL::Exact_rational;

constexpr double kUnit = 0x1p-100;  // relative error of an operation on DoubleDoubles
constexpr double kHalfUlp = 0x1p-53;
// Between these no product of the filters below over- or underflows.
constexpr double kSmall = 0x1p-400, kLarge = 0x1p+400;

Sign sign_of(double x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; }
Sign sign_of(const Rational& x) { return static_cast<Sign>(static_cast<int>(CGAL::sign(x))); }

/// ux * vy - uy * vx with its error.
struct CrossProduct {
  DoubleDouble value;
  double error;
  CrossProduct(DoubleDouble ux, DoubleDouble uy, DoubleDouble vx, DoubleDouble vy)
      : value(ux * vy - uy * vx),
        error(4 * kUnit * (std::abs(ux.high * vy.high) + std::abs(uy.high * vx.high))) {}

  /// Whether the error is small beside the value and nothing over- or underflows.
  [[nodiscard]] bool is_safe() const {
    const double size = std::abs(value.high);
    return size > kSmall && size < kLarge && 1024 * error < size;
  }
};

/// A coordinate of a crossing, and whether it is the double.
struct Coordinate {
  double nearest;
  bool is_double;
};

/// from + num / den * step, if that can be rounded without doubt and is not a double itself.
std::optional<Coordinate> coordinate(double from, DoubleDouble step, const CrossProduct& num,
                                     const CrossProduct& den) {
  const double slope = std::abs(step.high / den.value.high);
  const DoubleDouble way = num.value * step / den.value;
  const DoubleDouble at = DoubleDouble{from, 0} + way;
  // Each error once, and as much again for what the errors do to each other.
  const double error =
      2 * (slope * num.error + std::abs(way.high) * (den.error / std::abs(den.value.high)) +
           4 * kUnit * (std::abs(way.high) + std::abs(at.high)));
  const double half_gap = (std::abs(at.high) - std::nextafter(std::abs(at.high), 0.0)) / 2;
  if (!(std::abs(at.low) + error < half_gap && std::abs(at.low) > error)) return {};
  return Coordinate{at.high, false};
}

/// The coordinate that one of two segments has everywhere.
std::optional<Coordinate> common(double sa, double sb, double ta, double tb) {
  if (sa == sb) return Coordinate{sa, true};
  if (ta == tb) return Coordinate{ta, true};
  return {};
}

/// The double nearest to an exact number.
double nearest(const Rational& exact) {
  const double d = CGAL::to_double(exact);
  const Rational error = exact - Rational(d);
  if (error == 0) return d;
  const double other = std::nextafter(d, error > 0 ? HUGE_VAL : -HUGE_VAL);
  if (!std::isfinite(other)) return d;
  return CGAL::abs(Rational(exact - Rational(other))) < CGAL::abs(error) ? other : d;
}

Coordinate round_exact(const Rational& exact) {
  const double d = nearest(exact);
  return {d, Rational(d) == exact};
}

}  // namespace

struct SweepPoint::Exact {
  Rational x, y;
};

const SweepPoint::Exact& SweepPoint::exact() const {
  if (exact_) return *exact_;
  if (is_double()) {
    exact_ = std::make_shared<Exact>(Exact{rounded_.x, rounded_.y});
    return *exact_;
  }
  const auto difference = [](double to, double from) -> Rational {
    return Rational(to) - Rational(from);
  };
  const Rational ux = difference(s_.b.x, s_.a.x), uy = difference(s_.b.y, s_.a.y);
  const Rational vx = difference(t_.b.x, t_.a.x), vy = difference(t_.b.y, t_.a.y);
  const Rational wx = difference(t_.a.x, s_.a.x), wy = difference(t_.a.y, s_.a.y);
  const Rational place = (wx * vy - wy * vx) / (ux * vy - uy * vx);
  exact_ = std::make_shared<Exact>(Exact{s_.a.x + place * ux, s_.a.y + place * uy});
  return *exact_;
}

SweepPoint::SweepPoint(const PlainSegment& s, const PlainSegment& t)
    : x_is_double_(false), y_is_double_(false), s_(s), t_(t) {
  auto x = common(s.a.x, s.b.x, t.a.x, t.b.x), y = common(s.a.y, s.b.y, t.a.y, t.b.y);
  if (!x || !y) {
    const DoubleDouble ux = two_difference(s.b.x, s.a.x), uy = two_difference(s.b.y, s.a.y);
    const DoubleDouble vx = two_difference(t.b.x, t.a.x), vy = two_difference(t.b.y, t.a.y);
    const DoubleDouble wx = two_difference(t.a.x, s.a.x), wy = two_difference(t.a.y, s.a.y);
    const CrossProduct num(wx, wy, vx, vy), den(ux, uy, vx, vy);
    if (num.is_safe() && den.is_safe()) {
      if (!x) x = coordinate(s.a.x, ux, num, den);
      if (!y) y = coordinate(s.a.y, uy, num, den);
    }
    if (!x) x = round_exact(exact().x);
    if (!y) y = round_exact(exact().y);
  }
  rounded_ = {x->nearest, y->nearest};
  x_is_double_ = x->is_double;
  y_is_double_ = y->is_double;
}

Sign compare(const SweepPoint& p, const SweepPoint& q) {
  if (p.rounded_.x != q.rounded_.x) return sign_of(p.rounded_.x - q.rounded_.x);
  if (!p.x_is_double_ || !q.x_is_double_) {
    const Sign x = sign_of(Rational(p.exact().x - q.exact().x));
    if (x != Sign::zero) return x;
  }
  if (p.rounded_.y != q.rounded_.y) return sign_of(p.rounded_.y - q.rounded_.y);
  if (p.y_is_double_ && q.y_is_double_) return Sign::zero;
  return sign_of(Rational(p.exact().y - q.exact().y));
}

Sign SweepPoint::side_of(Point a, Point b) const {
  if (is_double()) return orientation(a, b, rounded_);
  // Rounding moved the point by half a unit in the last place of each coordinate at most.
  const double ux = b.x - a.x, uy = b.y - a.y;
  const double left = ux * (rounded_.y - a.y), right = uy * (rounded_.x - a.x);
  const double moved = std::abs(ux * rounded_.y) + std::abs(uy * rounded_.x);
  const double error = 8 * kHalfUlp * (std::abs(left) + std::abs(right)) + 2 * kHalfUlp * moved;
  if (error > kSmall && error < kLarge && std::abs(left - right) > error) {
    return sign_of(left - right);
  }
  const Rational exact_left = (Rational(b.x) - Rational(a.x)) * (exact().y - Rational(a.y));
  const Rational exact_right = (Rational(b.y) - Rational(a.y)) * (exact().x - Rational(a.x));
  return sign_of(Rational(exact_left - exact_right));
}

Sign SweepPoint::compare_distances(Point a, Point b) const {
  const auto squared = [this](Point p) -> Rational {
    const Rational dx = exact().x - Rational(p.x), dy = exact().y - Rational(p.y);
    return dx * dx + dy * dy;
  };
  return sign_of(Rational(squared(a) - squared(b)));
}

}  // namespace cover
