#include <cover/units.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

struct LengthUnit {
  std::string_view name;
  int ten;  ///< metres are 10^ten
};
constexpr std::array<LengthUnit, 5> kUnits{
    {{"nm", -9}, {"um", -6}, {"mm", -3}, {"cm", -2}, {"m", 0}}};

/// Units of drawings that are none of ours, in metres, and one of ours that is near.
struct OtherUnit {
  std::string_view name;
  double metres;
  std::string_view near;
};
constexpr std::array<OtherUnit, 10> kOtherUnits{{{"inches", 0.0254, "mm"},
                                                 {"feet", 0.3048, "m"},
                                                 {"miles", 1609.344, "m"},
                                                 {"kilometres", 1000, "m"},
                                                 {"microinches", 2.54e-8, "nm"},
                                                 {"mils", 2.54e-5, "um"},
                                                 {"yards", 0.9144, "m"},
                                                 {"angstroms", 1e-10, "nm"},
                                                 {"decimetres", 0.1, "m"},
                                                 {"US survey feet", 1200.0 / 3937, "m"}}};

const OtherUnit* find_other(std::string_view name) {
  const auto* const found = std::find_if(kOtherUnits.begin(), kOtherUnits.end(),
                                         [&](const OtherUnit& u) { return u.name == name; });
  return found != kOtherUnits.end() ? found : nullptr;
}

std::optional<double> metres_of(std::string_view name) {
  if (const OtherUnit* const other = find_other(name)) return other->metres;
  for (const LengthUnit& unit : kUnits)
    if (unit.name == name) return std::pow(10, unit.ten);
  return std::nullopt;
}

/// Tells what makes a drawing one in our units, unless options have seen to it.
void tell_of_other_unit(Input& input, const ReadOptions& options) {
  const OtherUnit* const other = find_other(input.other_unit);
  if (other == nullptr || (!options.unit.empty() && options.scale != 1)) return;
  const std::string unit = options.unit.empty() ? std::string(other->near) : options.unit;
  const std::string scale =
      fmt::format("--scale {:.10g}", factor_between(other->name, unit).value_or(1));
  input.warnings.push_back(
      options.unit.empty()
          ? fmt::format("the drawing is in {}: {} --unit {} makes it {}", other->name, scale, unit,
                        unit)
          : fmt::format("the option unit says {}, and the drawing is in {}: {} makes it {}", unit,
                        other->name, scale, unit));
}

/// The unit of numbers that were of `unit` before they became 10^ten times as large; empty: it has
/// no name.
std::string unit_after(std::string_view unit, std::optional<int> ten) {
  const auto* const from = std::find_if(kUnits.begin(), kUnits.end(),
                                        [&](const LengthUnit& u) { return u.name == unit; });
  if (from == kUnits.end() || !ten) return {};
  const auto* const to = std::find_if(
      kUnits.begin(), kUnits.end(), [&](const LengthUnit& u) { return u.ten == from->ten - *ten; });
  return to != kUnits.end() ? std::string(to->name) : std::string();
}

}  // namespace

bool is_length_unit(std::string_view unit) {
  return std::any_of(kUnits.begin(), kUnits.end(),
                     [&](const LengthUnit& u) { return u.name == unit; });
}

std::optional<double> factor_between(std::string_view from, std::string_view to) {
  const std::optional<double> of = metres_of(from), by = metres_of(to);
  if (!of || !by) return std::nullopt;
  return *of / *by;
}

Status scale_input(Input& input, double factor) {
  if (!(factor > 0 && std::isfinite(factor)))
    return Error{
        ErrorCode::bad_option, fmt::format("the scale {} is not a number above 0", factor), {}, {}};
  int exponent = 0;
  const bool power_of_two = std::frexp(factor, &exponent) == 0.5;
  const std::optional<int> ten = power_of_ten(factor);
  const double divisor = ten && *ten < 0 ? std::round(1 / factor) : 1;
  const auto scaled = [&](double value) { return divisor > 1 ? value / divisor : value * factor; };

  input.scale *= factor;
  if (factor != 1) input.unit = unit_after(input.unit, ten);
  bool finite = true;
  std::size_t rounded = 0, coordinates = 0;
  const auto scale = [&](double& value) {
    const double product = scaled(value);
    finite &= std::isfinite(product);
    ++coordinates;
    if (!power_of_two && !ten && std::fma(value, factor, -product) != 0) ++rounded;
    value = product;
  };
  for_each_point(input, [&](Point& p) {
    scale(p.x);
    scale(p.y);
  });
  // A size beyond all doubles is no limit, as the largest one is.
  const auto scaled_size = [&](double size) {
    return std::min(scaled(size), std::numeric_limits<double>::max());
  };
  for (RegionSeed& seed : input.seeds)
    if (seed.size) seed.size = scaled_size(*seed.size);
  for (InputPolygon& polygon : input.polygons)
    if (polygon.size) polygon.size = scaled_size(*polygon.size);
  if (input.field) {
    PlaneField field = *input.field;
    for (Point& p : field.points) p = {scaled(p.x), scaled(p.y)};
    input.field = std::make_shared<const PlaneField>(std::move(field));
  }
  for (ArcCircle& circle : input.circles) circle.radius = scaled(circle.radius);
  for (LayerRule& rule : input.layers) rule.first = scaled(rule.first);
  if (!finite)
    return Error{ErrorCode::non_finite_coordinate,
                 fmt::format("{}: scaled by {}, coordinates are too large for a double",
                             input.source, factor),
                 {},
                 {}};
  if (rounded > 0)
    input.warnings.push_back(fmt::format(
        "{} of {} coordinates times {} are rounded to the nearest double: points that were on one "
        "line may not be so any more",
        rounded, coordinates, factor));
  return ok();
}

Status apply_units(Input& input, const ReadOptions& options) {
  const std::string before = input.unit;
  tell_of_other_unit(input, options);
  if (options.scale != 1 || !options.unit.empty()) input.other_unit.clear();
  if (options.scale != 1) {
    if (Status status = scale_input(input, options.scale); !status) return status;
  }
  if (options.unit.empty()) {
    if (!before.empty() && input.unit.empty())
      input.warnings.push_back(
          fmt::format("lengths in {} times {} are in no unit with a name: the option unit may give "
                      "them one",
                      before, options.scale));
    return ok();
  }
  // Another scale may make up for a file that does not mean the unit that it says.
  if (!before.empty() && input.unit.empty() && power_of_ten(options.scale))
    input.warnings.push_back(fmt::format(
        "the option unit says {}, and lengths in {} times {} are not in it: {} is taken",
        options.unit, before, options.scale, options.unit));
  if (!input.unit.empty() && input.unit != options.unit)
    input.warnings.push_back(fmt::format(
        "the option unit says {}, and the input {}{}: {} is taken", options.unit, before,
        options.scale == 1 ? std::string()
                           : fmt::format(", which times {} is {}", options.scale, input.unit),
        options.unit));
  input.unit = options.unit;
  return ok();
}

}  // namespace cover
