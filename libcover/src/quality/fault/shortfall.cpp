// See shortfall.hpp. Tested by tests/unit/quality/fault/merit_test.cpp.
#include "quality/fault/shortfall.hpp"

#include <algorithm>
#include <array>

namespace cover {

Shortfall shortfall_of(const MutableMesh& mesh, std::uint32_t t, const Goal& goal) {
  const auto& n = mesh.triangles[t].n;
  const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
  const bool is_set = mesh.goal() == goal;
  std::array<Allowance, 3> other;  // by a goal that is not the one set
  SideAllowances sides{};
  double allowed_small = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_side(n[i])) continue;
    if (!is_set) other[i] = allowance_for(mesh.sides[side_index(n[i])], goal);
    sides[i] = is_set ? mesh.allowance(n[i]) : &other[i];
    allowed_small = std::max(allowed_small, sides[i]->small);
  }
  Shortfall shortfall;
  shortfall.fault = fault_of(k, sides, goal);
  for (std::size_t i = 0; i < 3; ++i) {
    const double cot = k.cross > 0 ? k.dot[i] / k.cross : -kInverted;
    const double limit = goal.large + (sides[i] != nullptr ? sides[i]->large : 0);
    shortfall.largest = std::max(shortfall.largest, -cot);
    shortfall.large = std::max(shortfall.large, -cot - limit);
    shortfall.is_far = shortfall.is_far || -cot > std::max(kFarAbove, limit) + kSameCot;
    const bool of_the_input = is_side(n[(i + 1) % 3]) && is_side(n[(i + 2) % 3]);
    if (!of_the_input)
      shortfall.small = std::max(shortfall.small, cot - goal.small - allowed_small);
  }
  return shortfall;
}

}  // namespace cover
