// Turns by an angle in degrees, as drawings have them.
#pragma once

#include <algorithm>
#include <cmath>

#include <cover/angle.hpp>

#include "geom/ulp.hpp"

namespace cover {

/// The same direction in [0, 360), so that -30 and 330 are one.
inline double reduced_degrees(double degrees) {
  double r = std::fmod(degrees, 360);
  if (r < 0) r += 360;
  return r < 360 ? r : 0;  // -1e-20 + 360 rounds up to 360
}

/// Whether it is once around from one angle to the other, up to the rounding of both and of their
/// difference: 1.2 and 361.2 as doubles are not 360 apart.
inline bool is_full_turn(double from, double to) {
  const double spacing = spacing_at(std::max(std::abs(from), std::abs(to)));
  return std::abs(std::abs(to - from) - 360) <= 2 * spacing;
}

/// A turn counter-clockwise.
struct Turn {
  double cosine = 1;
  double sine = 0;

  /// EXACT: quarters of a turn, so that what is drawn along the axes stays so
  static Turn by_degrees(double degrees) {
    const double rest = reduced_degrees(degrees), radians = Angle::degrees(rest).in_radians();
    const Turn turn{std::cos(radians), std::sin(radians)};
    return std::fmod(rest, 90) == 0 ? Turn{std::round(turn.cosine), std::round(turn.sine)} : turn;
  }
};

}  // namespace cover
