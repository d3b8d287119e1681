// See shortfall.hpp. Tested by tests/unit/quality/fault/merit_test.cpp.
#include "quality/fault/shortfall.hpp"

#include <algorithm>
#include <array>

namespace cover {

Shortfall shortfall_of(const MutableMesh& mesh, std::uint32_t t, const Goal& goal) {
  const auto& n = mesh.triangles[t].n;
  const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
  std::array<double, 3> allowed_large{};
  double allowed_small = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_side(n[i])) continue;
    const Allowance allowance = allowance_for(mesh.sides[side_index(n[i])], goal);
    allowed_large[i] = allowance.large;
    allowed_small = std::max(allowed_small, allowance.small);
  }
  Shortfall shortfall;
  for (std::size_t i = 0; i < 3; ++i) {
    const double cot = k.cross > 0 ? k.dot[i] / k.cross : -kInverted;
    const double limit = goal.large + allowed_large[i];
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
