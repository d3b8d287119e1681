// Tested by tests/unit/geom/isometry_test.cpp.
#include "geom/isometry.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace cover {
namespace {

constexpr double kSameAngle = 1e-11;        ///< degrees: what radians cost
constexpr double kSameDirection = 0x1p-36;  ///< of unit vectors

DoubleDouble sum_of(Isometry::Coefficient c) { return {c[0], c[1]}; }
Isometry::Coefficient parts_of(DoubleDouble x) { return {x.high, x.low}; }

DoubleDouble row_times(Isometry::Coefficient cx, Isometry::Coefficient cy, DoubleDouble x,
                       DoubleDouble y) {
  return sum_of(cx) * x + sum_of(cy) * y;
}

DoubleDouble parts_of_long(long double x) {
  const auto high = static_cast<double>(x);
  return {high, static_cast<double>(x - static_cast<long double>(high))};
}

/// Cosine and sine of an angle in [0, 90) degrees.
std::array<DoubleDouble, 2> cosine_and_sine(double degrees) {
  constexpr double kSixth = 30, kThird = 60;
  const long double angle = static_cast<long double>(degrees) *
                            (std::numbers::pi_v<long double> / static_cast<long double>(180));
  DoubleDouble c = parts_of_long(std::cos(angle)), s = parts_of_long(std::sin(angle));
  if (degrees == 0) c = {1, 0}, s = {0, 0};
  if (degrees == kThird) c = {0.5, 0};
  if (degrees == kSixth) s = {0.5, 0};
  return {c, s};
}

/// The multiple of 2^-10 degrees that an angle is up to rounding.
std::optional<double> in_whole_parts(Angle angle) {
  constexpr double kParts = 1 << 10;
  const double nearest = std::round(angle.in_degrees() * kParts) / kParts;
  if (std::abs(nearest - angle.in_degrees()) > kSameAngle) return std::nullopt;
  return nearest;
}

/// Cosine and sine of any angle; radians that stand for round degrees are taken for these.
std::array<DoubleDouble, 2> cosine_and_sine(Angle angle) {
  const std::optional<double> round = in_whole_parts(angle);
  if (!round) {
    const auto radians = static_cast<long double>(angle.in_radians());
    return {parts_of_long(std::cos(radians)), parts_of_long(std::sin(radians))};
  }
  constexpr double kTurn = 360, kQuarter = 90;
  double degrees = std::fmod(*round, kTurn);
  if (degrees < 0) degrees += kTurn;
  const double quarters = std::floor(degrees / kQuarter);
  auto [c, s] = cosine_and_sine(degrees - kQuarter * quarters);
  for (int k = 0; k < static_cast<int>(quarters); ++k) {
    const DoubleDouble old = c;
    c = -s;
    s = old;
  }
  return {c, s};
}

/// `map` with the shift that keeps `centre`, or takes it to `to`.
Isometry about(Isometry map, Point centre, Point to) {
  const DoubleDouble x{centre.x, 0}, y{centre.y, 0};
  return with_shift(map, DoubleDouble{to.x, 0} - row_times(map.xx, map.xy, x, y),
                    DoubleDouble{to.y, 0} - row_times(map.yx, map.yy, x, y));
}

}  // namespace

Point image_of(const Isometry& map, Point p) {
  const DoubleDouble x{p.x, 0}, y{p.y, 0};
  return {(row_times(map.xx, map.xy, x, y) + sum_of(map.x0)).high,
          (row_times(map.yx, map.yy, x, y) + sum_of(map.y0)).high};
}

Isometry inverse_of(const Isometry& map) {
  Isometry back = map;
  back.xy = map.yx;
  back.yx = map.xy;
  const DoubleDouble x = sum_of(map.x0), y = sum_of(map.y0);
  return with_shift(back, -row_times(back.xx, back.xy, x, y), -row_times(back.yx, back.yy, x, y));
}

Isometry with_shift(Isometry map, DoubleDouble x0, DoubleDouble y0) {
  map.x0 = parts_of(x0);
  map.y0 = parts_of(y0);
  return map;
}

Isometry translation_by(Vector by) { return with_shift({}, {by.x, 0}, {by.y, 0}); }

Isometry rotation_about(Point centre, Angle angle) {
  const auto [c, s] = cosine_and_sine(angle);
  Isometry map;
  map.xx = map.yy = parts_of(c);
  map.yx = parts_of(s);
  map.xy = parts_of(-s);
  return about(map, centre, centre);
}

Isometry reflection_between(Point p, Point q) {
  const Vector along = (1 / length(q - p)) * (q - p);
  DoubleDouble dx = two_difference(q.x, p.x), dy = two_difference(q.y, p.y);
  if (std::abs(along.x) < kSameDirection) dx = {0, 0};
  if (std::abs(along.y) < kSameDirection) dy = {0, 0};
  if (std::abs(std::abs(along.x) - std::abs(along.y)) < kSameDirection) {
    dx = {along.x < 0 ? -1.0 : 1.0, 0};
    dy = {along.y < 0 ? -1.0 : 1.0, 0};
  }
  const DoubleDouble squares = dx * dx + dy * dy, one{1, 0}, two{2, 0};
  Isometry map;
  map.xx = parts_of(one - two * dx * dx / squares);
  map.yy = parts_of(one - two * dy * dy / squares);
  map.xy = map.yx = parts_of(-(two * dx * dy / squares));
  return about(map, p, q);
}

}  // namespace cover
