// Tested by tests/unit/pipeline/cover_mesh_test.cpp.
#include "pipeline/check_options.hpp"

#include <fmt/core.h>

#include "base/errors.hpp"

namespace cover {
namespace {

Status check(const char* name, double value, const Range& range) {
  if (range.holds(value)) return ok();
  return bad_option(fmt::format("{} is {}, but must be {}", name, value, describe(range)));
}

/// `range` is in degrees.
Status check(const char* name, Angle value, const Range& range) {
  // In radians, where an angle made of the limit itself is the limit.
  const Range radians{Angle::degrees(range.low).in_radians(),
                      Angle::degrees(range.high).in_radians(), range.has_low, range.has_high};
  if (radians.holds(value.in_radians())) return ok();
  return bad_option(fmt::format("{} is {:.12g} degrees, but must be {}", name, value.in_degrees(),
                                describe(range)));
}

}  // namespace

std::string describe(const Range& range) {
  std::string text = fmt::format("{} {}", range.has_low ? "at least" : "above", range.low);
  if (range.high < ranges::kNoLimit)
    text += fmt::format(" and {} {}", range.has_high ? "at most" : "below", range.high);
  return text;
}

Status check_options(const Options& options) {
  if (options.paper && options.method != Method::almond) {
    return bad_option("the publication describes the almond method: paper needs method almond");
  }
  for (const Status& status :
       {check("pieces", options.pieces, ranges::kPieces),
        check("max_angle", options.max_angle, ranges::kMaxAngle),
        check("min_angle", options.min_angle, ranges::kMinAngle),
        options.growth ? check("growth", *options.growth, ranges::kGrowth) : ok(),
        options.weld ? check("weld", *options.weld, ranges::kWeld) : ok(),
        options.split_interfaces
            ? check("split_interfaces", *options.split_interfaces, ranges::kSplitInterfaces)
            : ok()}) {
    if (!status) return status;
  }
  for (const SizeRule& rule : options.sizes) {
    const std::string name = fmt::format("the size for '{}'", rule.name);
    if (Status status = check(name.c_str(), rule.size, ranges::kSize); !status) return status;
  }
  return ok();
}

}  // namespace cover
