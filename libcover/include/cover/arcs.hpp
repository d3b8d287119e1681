// Circles that segments are chords of, so that what is put on such a segment lies on its circle.
#pragma once

#include <cover/point.hpp>

namespace cover {

/// A circle of the input. A chord stands for the shorter of the two arcs between its ends, which
/// lie on the circle up to rounding.
struct ArcCircle {
  Point centre;
  double radius = 0;  ///< > 0
  friend constexpr auto operator<=>(const ArcCircle&, const ArcCircle&) = default;
};

}  // namespace cover
