// The one point type of the interfaces.
#pragma once

#include <compare>

namespace cover {

/// A point of the plane, in the length unit of the input. Ordered by x, then y.
struct Point {
  double x = 0;
  double y = 0;
  friend constexpr auto operator<=>(const Point&, const Point&) = default;
};

}  // namespace cover
