#include "pipeline/check_options.hpp"

#include <cmath>

#include <fmt/format.h>

namespace cover {
namespace {

Error bad_option(std::string message) {
  return {ErrorCode::bad_option, std::move(message), {}, {}};
}

}  // namespace

// The conditions are written so that a NaN fails them.
Status check_options(const Options& options) {
  if (options.pieces < 2) {
    return bad_option(fmt::format("pieces is {}, but must be at least 2", options.pieces));
  }
  const double max = options.max_angle.in_degrees(), min = options.min_angle.in_degrees();
  if (!(max > 60 && max < 180)) {
    return bad_option(fmt::format("max_angle is {} degrees, but must lie between 60 and 180", max));
  }
  if (!(min >= 0 && min < 60)) {
    return bad_option(
        fmt::format("min_angle is {} degrees, but must be at least 0 and below 60", min));
  }
  if (!(options.growth > 1 && std::isfinite(options.growth))) {
    return bad_option(fmt::format("growth is {}, but must be above 1", options.growth));
  }
  if (options.weld && !(*options.weld >= 0 && *options.weld < 1)) {
    return bad_option(
        fmt::format("weld is {}, but must be at least 0 and below 1 (relative)", *options.weld));
  }
  if (options.split_interfaces) {
    const double split = options.split_interfaces->in_degrees();
    if (!(split >= 60 && split < 180)) {
      return bad_option(fmt::format(
          "split_interfaces is {} degrees, but must be at least 60 and below 180", split));
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
