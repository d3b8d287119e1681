// How far a triangle is from what is wanted, or possible, in one number.
#pragma once

#include <algorithm>

#include "target/goal.hpp"

namespace cover {

/// The balanced measure: 0 meets the target, 1 is degenerate. What the input forces on the triangle
/// counts as the target: gamma_opt of the side opposite to a corner, the smallest angle that a
/// side leaves room for.
struct Fault {
  double wide = 0;    ///< (largest - target) / (180 - target), at the corner where it is most
  double narrow = 0;  ///< (target - smallest) / target; corners between two sides do not count
  [[nodiscard]] double worst() const { return std::max(wide, narrow); }
};

/// The fault of the triangle with these corners.
///
/// EXACT: nothing; zero where the excess is
Fault fault_of(const Corners& k, const SideAllowances& sides, const Goal& goal);

}  // namespace cover
