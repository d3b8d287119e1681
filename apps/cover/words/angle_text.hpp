// Angles for people.
#pragma once

#include <string>

#include <cover/report.hpp>

namespace cover::app {

/// pi - nu in degrees; as a difference where digits would be lost.
std::string angle_text(Angle nu);

/// An angle in degrees; in powers of ten where two places would show nothing.
std::string small_angle_text(Angle angle);

/// A part of a hundred with its sign and so many places; without one where they show nothing.
std::string percent_text(double part, int digits);

/// pi minus the lowest largest angle that a mesh of the region can have: no triangulation is below
/// 60 degrees.
Angle lowest_nu(const RegionReport& region);

}  // namespace cover::app
