// The lowest point of the maximum of linear functions in the plane, or a step on the way there.
#pragma once

#include <span>

#include "geom/vector.hpp"

namespace cover {

/// value + slope . step
struct LinearPiece {
  double value, slope_x, slope_y;  ///< no constructor: many are made and few are used
  [[nodiscard]] Vector slope() const { return {slope_x, slope_y}; }
  [[nodiscard]] double at(Vector step) const {
    return value + (slope_x * step.x + slope_y * step.y);
  }
};

/// A step, and what the largest piece is there.
struct Descent {
  Vector step;
  double value;
  bool is_cut_short;  ///< by the radius: farther away the pieces would be lower
};

/// Descends on the largest of `pieces` from step 0 until it is at `level`, until the step is as
/// long as `radius`, or until no piece can be lowered without another one rising.
///
/// REQUIRES: at least one piece
/// Cost:     O(pieces) per change of the pieces that tie, of which there are few
Descent descend(std::span<const LinearPiece> pieces, double level, double radius);

}  // namespace cover
