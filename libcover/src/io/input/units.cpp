#include <cover/units.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace cover {
namespace {

/// k where `factor` is the double nearest to 10^k, of those whose power is exact.
std::optional<int> power_of_ten(double factor) {
  constexpr int kLargestExact = 22;  // 5^22 < 2^53
  double power = 1;
  for (int k = 0; k <= kLargestExact; ++k, power *= 10) {
    if (factor == power) return k;
    if (factor == 1 / power) return -k;
  }
  return std::nullopt;
}

template <class F>
void for_each_point(Input& input, F f) {
  for (Point& p : input.points) f(p);
  for (HoleSeed& hole : input.holes) f(hole.at);
  for (RegionSeed& seed : input.seeds) f(seed.at);
  for (InputPolygon& polygon : input.polygons)
    for (auto& ring : polygon.rings)
      for (Point& p : ring) f(p);
  for (InputLine& line : input.lines)
    for (Point& p : line.points) f(p);
  for (ArcCircle& circle : input.circles) f(circle.centre);
  for (PeriodicRule& rule : input.periodic) f(rule.centre);
}

}  // namespace

bool is_length_unit(std::string_view unit) {
  constexpr std::array<std::string_view, 5> kUnits{"nm", "um", "mm", "cm", "m"};
  return std::find(kUnits.begin(), kUnits.end(), unit) != kUnits.end();
}

Status scale_input(Input& input, double factor) {
  int exponent = 0;
  const bool power_of_two = factor > 0 && std::frexp(factor, &exponent) == 0.5;
  const std::optional<int> ten = power_of_ten(factor);
  if (!power_of_two && !ten)
    return Error{ErrorCode::bad_option,
                 fmt::format("the scale {} is neither a power of ten nor of two", factor),
                 {},
                 {}};
  const double divisor = ten && *ten < 0 ? std::round(1 / factor) : 1;
  const auto scaled = [&](double value) { return divisor > 1 ? value / divisor : value * factor; };

  input.scale *= factor;
  bool finite = true;
  for_each_point(input, [&](Point& p) {
    p = {scaled(p.x), scaled(p.y)};
    finite &= std::isfinite(p.x) && std::isfinite(p.y);
  });
  for (RegionSeed& seed : input.seeds)
    if (seed.size) seed.size = scaled(*seed.size);
  for (InputPolygon& polygon : input.polygons)
    if (polygon.size) polygon.size = scaled(*polygon.size);
  if (input.field) {
    PlaneField field = *input.field;
    for (Point& p : field.points) p = {scaled(p.x), scaled(p.y)};
    input.field = std::make_shared<const PlaneField>(std::move(field));
  }
  for (ArcCircle& circle : input.circles) circle.radius = scaled(circle.radius);
  if (!finite)
    return Error{ErrorCode::non_finite_coordinate,
                 fmt::format("{}: scaled by {}, coordinates are too large for a double",
                             input.source, factor),
                 {},
                 {}};
  return ok();
}

}  // namespace cover
