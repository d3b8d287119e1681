// See standing.hpp. Tested by tests/unit/quality/fault/standing_test.cpp.
#include "quality/fault/standing.hpp"

#include <algorithm>

#include "quality/fault/shortfall.hpp"

namespace cover {

GoalStanding standing_of(const MutableMesh& mesh, const Goal& goal) {
  GoalStanding standing;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    const Shortfall shortfall = cots_short_of(mesh, t, goal);
    standing.largest = std::max(standing.largest, shortfall.largest);
    standing.large = std::max(standing.large, shortfall.large);
    standing.above += shortfall.is_above() ? 1 : 0;
    standing.far_above += shortfall.is_far ? 1 : 0;
    if (goal.weight > 0) standing.small = std::max(standing.small, shortfall.small);
    standing.below += shortfall.is_below(goal) ? 1 : 0;
    standing.negative += shortfall.negative;
  }
  return standing;
}

}  // namespace cover
