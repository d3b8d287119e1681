// Angles for people.
#pragma once

#include <string>

#include <cover/report.hpp>

namespace cover::app {

/// pi - nu in degrees; as a difference where digits would be lost.
std::string angle_text(Angle nu);

/// pi minus the lowest largest angle that a mesh of the region can have: no triangulation is below
/// 60 degrees.
Angle lowest_nu(const RegionReport& region);

}  // namespace cover::app
