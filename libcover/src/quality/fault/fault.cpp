// See fault.hpp. Tested by tests/unit/quality/fault/fault_test.cpp.
#include "quality/fault/fault.hpp"

#include <algorithm>
#include <numbers>

#include "geom/cotangent.hpp"

namespace cover {

Fault fault_of(const Corners& k, const SideAllowances& sides, const Goal& goal) {
  if (!(k.cross > 0)) return {1, 1};
  Fault fault;
  const double small = wanted_small(goal, sides);
  double sharpest = -kInverted;
  for (const Corner i : kCorners) {
    const double cot = k.dot[i] / k.cross;
    const double large = wanted_large(goal, sides[i]);
    if (-cot > large + kSameCot * std::max(1.0, large)) {
      const double target = angle_of_cot(-large);
      fault.wide = std::max(fault.wide, (angle_of_cot(cot) - target) / (std::numbers::pi - target));
    }
    if (!is_between_sides(sides, i)) sharpest = std::max(sharpest, cot);
  }
  if (goal.weight > 0 && is_sharper(sharpest, small))
    fault.narrow = 1 - angle_of_cot(sharpest) / angle_of_cot(small);
  return fault;
}

}  // namespace cover
