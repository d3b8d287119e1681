// Tested by tests/unit/options/periodic_rule_test.cpp.
#include "options/periodic_rule.hpp"

#include <cmath>

#include <fmt/core.h>

namespace cover {

Status check_rule(const PeriodicRule& rule) {
  const auto refuse = [&](const char* what) {
    return Error{ErrorCode::bad_option,
                 fmt::format("periodic: '{}' and '{}': {}", rule.from, rule.to, what),
                 {},
                 {}};
  };
  if (rule.from.empty() || rule.to.empty()) return refuse("each of the two lines needs a name");
  if (rule.from == rule.to) return refuse("a line cannot be taken to itself");
  if (rule.map == PeriodicRule::Map::glide) return refuse("a glide reflection cannot be asked for");
  if (rule.map != PeriodicRule::Map::rotation) return ok();
  constexpr double kTurn = 360, kLeast = 1e-9;
  if (!std::isfinite(rule.centre.x) || !std::isfinite(rule.centre.y) ||
      !std::isfinite(rule.angle.in_radians()))
    return refuse("the centre and the angle of a rotation must be finite");
  if (std::abs(std::remainder(rule.angle.in_degrees(), kTurn)) < kLeast)
    return refuse("a rotation by this angle takes every line to itself");
  return ok();
}

}  // namespace cover
