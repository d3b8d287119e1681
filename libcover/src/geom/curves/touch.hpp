// Where two circles touch, or a circle and a line.
#pragma once

#include <optional>

#include <cover/arcs.hpp>
#include <cover/point.hpp>

namespace cover {

/// A place where curves come next to each other, or overlap by as little.
struct Touch {
  Point at;              ///< between both; on the line where one is a line
  double gap = 0;        ///< between them there; below 0: they overlap
  double curvature = 0;  ///< that of one as seen from the other; > 0

  /// How far from the place the curves come apart by `distance`.
  [[nodiscard]] double half_width(double distance) const;
};

/// Where two circles touch, from outside or one inside the other, if they do so up to `reach`. The
/// gap is that between the very circles of the doubles that are stored, all but exactly, so that
/// nothing but their own rounding counts. One circle twice touches nowhere.
std::optional<Touch> touch_of(const ArcCircle& one, const ArcCircle& other, double reach);

/// The same of a circle and the line through a and b, however far beyond these that is.
///
/// REQUIRES: a != b
std::optional<Touch> touch_of(const ArcCircle& circle, Point a, Point b, double reach);

}  // namespace cover
