#include "angle_text.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace cover::app {

std::string angle_text(Angle nu) {
  const double degrees = nu.in_degrees();
  return degrees < 0.005 && degrees > 0 ? fmt::format("180-{:.1e}", degrees)
                                        : fmt::format("{:.2f}", 180 - degrees);
}

Angle lowest_nu(const RegionReport& region) { return std::min(region.nu_opt, Angle::degrees(120)); }

}  // namespace cover::app
