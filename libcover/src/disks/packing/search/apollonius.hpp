// The problem of Apollonius for disks and lines.
#pragma once

#include <array>

#include "disks/packing/disk.hpp"

namespace cover::disks {

/// Up to two circles.
struct TangentCircles {
  std::array<Circle, 2> circle;
  int count = 0;
};

/// The circles that touch three elements from outside (lines from their left).
///
/// `near` is a point near the expected contacts; all is computed relative to it.
/// EXACT: no; a Newton step leaves a residual of a few ulps of the distances involved.
TangentCircles tangent_circles(const Element& e1, const Element& e2, const Element& e3, Point near);

}  // namespace cover::disks
