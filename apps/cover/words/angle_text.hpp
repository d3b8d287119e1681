// Angles for people.
#pragma once

#include <string>

#include <cover/angle.hpp>

namespace cover::app {

/// pi - nu in degrees; as a difference where digits would be lost.
std::string angle_text(Angle nu);

/// An angle in degrees; in powers of ten where two places would show nothing.
std::string small_angle_text(Angle angle);

/// A part of a hundred with its sign and so many places; without one where they show nothing.
std::string percent_text(double part, int digits);

}  // namespace cover::app
