// Tested by tests/unit/pipeline/cover_mesh_test.cpp.
#include "pipeline/check_options.hpp"

#include <cmath>

#include <fmt/format.h>

namespace cover {
namespace {

constexpr Angle kSixty = Angle::degrees(60);
constexpr Angle kStraight = Angle::degrees(180);

Error bad_option(std::string message) {
  return {ErrorCode::bad_option, std::move(message), {}, {}};
}

}  // namespace

// The conditions are written so that a NaN fails them.
Status check_options(const Options& options) {
  if (options.pieces < 2) {
    return bad_option(fmt::format("pieces is {}, but must be at least 2", options.pieces));
  }
  if (options.paper && options.method != Method::almond) {
    return bad_option("the publication describes the almond method: paper needs method almond");
  }
  const Angle max = options.max_angle, min = options.min_angle;
  if (!(max > kSixty && max < kStraight)) {
    return bad_option(
        fmt::format("max_angle is {} degrees, but must lie between 60 and 180", max.in_degrees()));
  }
  if (!(min >= Angle() && min < kSixty)) {
    return bad_option(fmt::format("min_angle is {} degrees, but must be at least 0 and below 60",
                                  min.in_degrees()));
  }
  if (!(options.growth > 1 && std::isfinite(options.growth))) {
    return bad_option(fmt::format("growth is {}, but must be above 1", options.growth));
  }
  if (options.weld && !(*options.weld >= 0 && *options.weld < 1)) {
    return bad_option(
        fmt::format("weld is {}, but must be at least 0 and below 1 (relative)", *options.weld));
  }
  if (options.split_interfaces) {
    const Angle split = *options.split_interfaces;
    if (!(split >= kSixty && split < kStraight)) {
      return bad_option(
          fmt::format("split_interfaces is {} degrees, but must be at least 60 and below 180",
                      split.in_degrees()));
    }
  }
  for (const SizeRule& rule : options.sizes) {
    if (!(rule.size > 0 && std::isfinite(rule.size))) {
      return bad_option(fmt::format("the size for '{}' is {}, but must be a positive length",
                                    rule.name, rule.size));
    }
  }
  return ok();
}

}  // namespace cover
