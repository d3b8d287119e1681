// Angles by their cotangents, which compare as the angles do, the other way round, and come without
// a square root. In radians. Tested by tests/unit/geom/cotangent_test.cpp.
#pragma once

#include <cmath>

namespace cover {

/// The angle in [0, pi] with this cotangent, which may be infinite.
inline double angle_of_cot(double cot) { return std::atan2(1.0, cot); }

/// Infinite for an angle of 0.
inline double cot_of(double angle) { return 1 / std::tan(angle); }

}  // namespace cover
