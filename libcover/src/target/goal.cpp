// See goal.hpp.
// Tested by tests/unit/target/goal_test.cpp.
#include "target/goal.hpp"

#include <cmath>
#include <numbers>

#include "geom/topology/corner.hpp"

namespace cover {

Goal Goal::of(Angle max, Angle min) {
  Goal goal;
  goal.large = -1 / std::tan(max.in_radians());
  if (min.in_radians() > 0) {
    goal.small = 1 / std::tan(min.in_radians());
    goal.weight = min.in_radians() / (std::numbers::pi - max.in_radians());
  }
  return goal;
}

double excess(const Goal& goal, const Corners& k, const Allowance* const side[3]) {
  if (!(k.cross > 0)) return kInverted;
  double small = goal.small;
  for (const Corner i : kCorners) {
    if (side[i] != nullptr) small = std::max(small, goal.small + side[i]->small);
  }
  double worst = -kInverted;
  for (const Corner i : kCorners) {
    const double large = goal.large + (side[i] != nullptr ? side[i]->large : 0);
    worst = std::max(worst, -k.dot[i] - large * k.cross);
    const bool of_the_input = side[i.next()] != nullptr && side[i.previous()] != nullptr;
    if (!of_the_input) worst = std::max(worst, goal.weight * (k.dot[i] - small * k.cross));
  }
  return worst / k.cross;
}

}  // namespace cover
