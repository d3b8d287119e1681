// A part of the plane that is looked at.
#pragma once

#include <cover/point.hpp>

namespace cover {

/// A rectangle.
/// REQUIRES: low.x < high.x, low.y < high.y
struct Window {
  Point low;
  Point high;
};

}  // namespace cover
