// See standing.hpp. Tested by tests/unit/quality/search_test.cpp.
#include "quality/standing.hpp"

#include <algorithm>
#include <array>

#include "quality/merit.hpp"

namespace cover {
namespace {

constexpr double kGain = 0.01;  ///< of an excess, that is worth a change

}  // namespace

Standing standing_of(const MutableMesh& mesh, const Goal& goal) {
  Standing standing;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    const auto& n = mesh.triangles[t].n;
    const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    std::array<Allowance, 3> side{};
    double allowed = 0, large = -kInverted, small = -kInverted;
    bool far = false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_side(n[i])) continue;
      side[i] = allowance_for(mesh.sides[side_index(n[i])], goal);
      allowed = std::max(allowed, side[i].small);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const double cot = k.dot[i] / k.cross;
      standing.largest = std::max(standing.largest, -cot);
      large = std::max(large, -cot - goal.large - side[i].large);
      far = far || -cot > std::max(kFarAbove, goal.large + side[i].large) + kSameCot;
      if (is_side(n[(i + 1) % 3]) && is_side(n[(i + 2) % 3])) continue;
      small = std::max(small, cot - goal.small - allowed);
    }
    standing.large = std::max(standing.large, large);
    standing.above += large > kSameCot ? 1 : 0;
    standing.far_above += far ? 1 : 0;
    if (goal.weight == 0) continue;
    standing.small = std::max(standing.small, small);
    standing.below += small > kSameCot * goal.small ? 1 : 0;
  }
  return standing;
}

bool is_gain(const Standing& now, const Standing& before) {
  if (now.largest > before.largest || now.large > before.large || now.above > before.above ||
      now.far_above > before.far_above) {
    return false;
  }
  if (now.above < before.above || now.far_above < before.far_above ||
      now.large < (1 - kGain) * before.large) {
    return true;
  }
  if (now.below > before.below || now.small > before.small) return false;
  return now.below < before.below || now.small < (1 - kGain) * before.small;
}

}  // namespace cover
