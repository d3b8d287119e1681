// See goal.hpp.
// Tested by tests/unit/target/goal_test.cpp.
#include "target/goal.hpp"

#include <numbers>

#include "geom/cotangent.hpp"

namespace cover {

Goal Goal::of(Angle max, Angle min) {
  Goal goal;
  goal.large = -cot_of(max.in_radians());
  if (min.in_radians() > 0) {
    goal.small = cot_of(min.in_radians());
    goal.weight = min.in_radians() / (std::numbers::pi - max.in_radians());
  }
  return goal;
}

double excess(const Goal& goal, const Corners& k, const SideAllowances& sides) {
  if (!(k.cross > 0)) return kInverted;
  const double small = wanted_small(goal, sides);
  double worst = -kInverted;
  for (const Corner i : kCorners) {
    worst = std::max(worst, -k.dot[i] - wanted_large(goal, sides[i]) * k.cross);
    if (!is_between_sides(sides, i))
      worst = std::max(worst, goal.weight * (k.dot[i] - small * k.cross));
  }
  return worst / k.cross;
}

}  // namespace cover
