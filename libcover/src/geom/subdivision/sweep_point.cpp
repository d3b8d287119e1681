// A crossing is first computed with twice the digits of a double and a bound for the error, which
// nearly always tells the nearest double; then comparing roundings nearly always tells the order.
// What is left is decided by rational arithmetic; where many lines pass nearly through one point,
// that is the lines and points that coincide.
// Tested by tests/unit/geom/subdivision/sweep_point_test.cpp.
#include "geom/subdivision/sweep_point.hpp"

#include <CGAL/Exact_rational.h>

#include <cmath>
#include <optional>

#include "base/numbers.hpp"

namespace cover {
namespace {

using Rational = CGAL::Exact_rational;

constexpr double kUnit = 0x1p-100;  // relative error of an operation on DoubleDoubles
constexpr double kHalfUlp = 0x1p-53;
constexpr double kUnknown = kInfinity;
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

/// A coordinate of a crossing as far as the filter knows it.
struct Estimate {
  DoubleDouble at;
  double error = kUnknown;
  /// The nearest double, if that is beyond doubt; then it is not the coordinate itself, unless the
  /// error is zero.
  std::optional<double> nearest;
};

/// from + num / den * step
Estimate estimate(double from, DoubleDouble step, const CrossProduct& num,
                  const CrossProduct& den) {
  const double slope = std::abs(step.high / den.value.high);
  const DoubleDouble way = num.value * step / den.value;
  Estimate out;
  out.at = DoubleDouble{from, 0} + way;
  // Each error once, and as much again for what the errors do to each other.
  out.error = 2 * (slope * num.error + std::abs(way.high) * (den.error / std::abs(den.value.high)) +
                   4 * kUnit * (std::abs(way.high) + std::abs(out.at.high)));
  if (!(std::abs(out.at.high) > kSmall && std::abs(way.high) > kSmall)) {
    out.error = kUnknown;
    return out;
  }
  const double high = std::abs(out.at.high);
  const double half_gap = (high - std::nextafter(high, 0.0)) / 2;
  if (std::abs(out.at.low) + out.error < half_gap && std::abs(out.at.low) > out.error) {
    out.nearest = out.at.high;
  }
  return out;
}

/// The coordinate that one of two segments has everywhere.
Estimate common(double sa, double sb, double ta, double tb) {
  if (sa == sb) return {{sa, 0}, 0, sa};
  if (ta == tb) return {{ta, 0}, 0, ta};
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

/// Rounds an estimate whose nearest double is in doubt.
void round_exact(const Rational& exact, Estimate& estimate) {
  estimate.nearest = nearest(exact);
  if (Rational(*estimate.nearest) == exact)
    estimate = {{*estimate.nearest, 0}, 0, estimate.nearest};
}

/// The sign of a sum if its error cannot change it.
std::optional<Sign> sign_beyond_doubt(double sum, double error) {
  if (!(std::abs(sum) > 2 * error)) return {};
  return sign_of(sum);
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

SweepPoint::SweepPoint(const PlainSegment& s, const PlainSegment& t) : s_(s), t_(t) {
  Estimate x = common(s.a.x, s.b.x, t.a.x, t.b.x), y = common(s.a.y, s.b.y, t.a.y, t.b.y);
  if (!x.nearest || !y.nearest) {
    const DoubleDouble ux = two_difference(s.b.x, s.a.x), uy = two_difference(s.b.y, s.a.y);
    const DoubleDouble vx = two_difference(t.b.x, t.a.x), vy = two_difference(t.b.y, t.a.y);
    const DoubleDouble wx = two_difference(t.a.x, s.a.x), wy = two_difference(t.a.y, s.a.y);
    const CrossProduct num(wx, wy, vx, vy), den(ux, uy, vx, vy);
    if (num.is_safe() && den.is_safe()) {
      if (!x.nearest) x = estimate(s.a.x, ux, num, den);
      if (!y.nearest) y = estimate(s.a.y, uy, num, den);
    }
    x_is_double_ = y_is_double_ = false;
    if (!x.nearest) round_exact(exact().x, x);
    if (!y.nearest) round_exact(exact().y, y);
  }
  rounded_ = {*x.nearest, *y.nearest};
  x_is_double_ = x.error == 0;
  y_is_double_ = y.error == 0;
  x_ = x.at;
  y_ = y.at;
  x_error_ = x.error;
  y_error_ = y.error;
}

Sign compare(const SweepPoint& p, const SweepPoint& q) {
  if (p.rounded_.x != q.rounded_.x) return sign_of(p.rounded_.x - q.rounded_.x);
  if (!p.x_is_double_ || !q.x_is_double_) {
    if (const auto x = sign_beyond_doubt((p.x_ - q.x_).high, p.x_error_ + q.x_error_)) return *x;
    const Sign x = sign_of(Rational(p.exact().x - q.exact().x));
    if (x != Sign::zero) return x;
  }
  if (p.rounded_.y != q.rounded_.y) return sign_of(p.rounded_.y - q.rounded_.y);
  if (p.y_is_double_ && q.y_is_double_) return Sign::zero;
  if (const auto y = sign_beyond_doubt((p.y_ - q.y_).high, p.y_error_ + q.y_error_)) return *y;
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
  if (const auto sign = side_estimate(a, b)) return *sign;
  const Rational exact_left = (Rational(b.x) - Rational(a.x)) * (exact().y - Rational(a.y));
  const Rational exact_right = (Rational(b.y) - Rational(a.y)) * (exact().x - Rational(a.x));
  return sign_of(Rational(exact_left - exact_right));
}

std::optional<Sign> SweepPoint::side_estimate(Point a, Point b) const {
  const DoubleDouble ux = two_difference(b.x, a.x), uy = two_difference(b.y, a.y);
  const DoubleDouble wx = x_ - DoubleDouble{a.x, 0}, wy = y_ - DoubleDouble{a.y, 0};
  const CrossProduct product(ux, uy, wx, wy);
  const double moved = std::abs(ux.high) * y_error_ + std::abs(uy.high) * x_error_;
  const double size = std::abs(product.value.high);
  if (!(size > kSmall && size < kLarge)) return {};
  // The differences from a are rounded too: by kUnit of themselves.
  return sign_beyond_doubt(product.value.high, 2 * (product.error + moved));
}

double distance_along_y(const PlainSegment& s, Point p) {
  const DoubleDouble ux = two_difference(s.b.x, s.a.x), uy = two_difference(s.b.y, s.a.y);
  const DoubleDouble wx = two_difference(p.x, s.a.x), wy = two_difference(p.y, s.a.y);
  return std::abs((ux * wy - uy * wx).high / ux.high);
}

Sign SweepPoint::compare_distances(Point a, Point b) const {
  const auto squared = [this](Point p) -> Rational {
    const Rational dx = exact().x - Rational(p.x), dy = exact().y - Rational(p.y);
    return dx * dx + dy * dy;
  };
  return sign_of(Rational(squared(a) - squared(b)));
}

}  // namespace cover
