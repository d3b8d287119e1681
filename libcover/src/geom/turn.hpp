// Turns by an angle in degrees, as drawings have them.
#pragma once

#include <cmath>

#include <cover/angle.hpp>

namespace cover {

/// A turn counter-clockwise.
struct Turn {
  double cosine = 1;
  double sine = 0;

  /// EXACT: quarters of a turn, so that what is drawn along the axes stays so
  static Turn by_degrees(double degrees) {
    const double rest = std::fmod(degrees, 360), radians = Angle::degrees(rest).in_radians();
    const Turn turn{std::cos(radians), std::sin(radians)};
    return std::fmod(rest, 90) == 0 ? Turn{std::round(turn.cosine), std::round(turn.sine)} : turn;
  }
};

}  // namespace cover
