#include "words/angle_text.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace cover::app {

std::string angle_text(Angle nu) {
  const double degrees = nu.in_degrees();
  return degrees < 0.005 && degrees > 0 ? fmt::format("180-{:.1e}", degrees)
                                        : fmt::format("{:.2f}", 180 - degrees);
}

std::string small_angle_text(Angle angle) {
  const double degrees = angle.in_degrees();
  return degrees < 0.005 && degrees > 0 ? fmt::format("{:.1e}", degrees)
                                        : fmt::format("{:.2f}", degrees);
}

std::string percent_text(double part, int digits) {
  const std::string text = fmt::format("{:+.{}f}", part, digits);
  return text.find_first_of("123456789") == text.npos ? text.substr(1) + " %" : text + " %";
}

}  // namespace cover::app
