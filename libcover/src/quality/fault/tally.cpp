// See tally.hpp. Tested by tests/unit/quality/fault/tally_test.cpp.
#include "quality/fault/tally.hpp"

#include <algorithm>

#include "quality/fault/shortfall.hpp"

namespace cover {

Tally tally_of(const MutableMesh& mesh, const Goal& goal) {
  Tally tally;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    const Shortfall shortfall = cots_short_of(mesh, t, goal);
    tally.largest = std::max(tally.largest, shortfall.largest);
    tally.large = std::max(tally.large, shortfall.large);
    tally.above += shortfall.is_above() ? 1 : 0;
    tally.far_above += shortfall.is_far ? 1 : 0;
    if (goal.weight > 0) tally.small = std::max(tally.small, shortfall.small);
    tally.below += shortfall.is_below(goal) ? 1 : 0;
    tally.negative += shortfall.negative;
  }
  return tally;
}

}  // namespace cover
