// Numbers that have names.
#pragma once

#include <limits>
#include <numbers>

namespace cover {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// In place of a value: there is none.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A degree, in radians. Angle::degrees() rounds elsewhere: to change one for the other can change
/// the last digit.
inline constexpr double kDegree = std::numbers::pi / 180;
/// A radian, in degrees.
inline constexpr double kRadian = 180 / std::numbers::pi;

}  // namespace cover
