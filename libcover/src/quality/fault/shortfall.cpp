// See shortfall.hpp. Tested by tests/unit/quality/fault/merit_test.cpp.
#include "quality/fault/shortfall.hpp"

#include <algorithm>
#include <array>

namespace cover {
namespace {

/// Whether the coupling of edge i of `t`, with the cotangent opposite to it in `t`, is negative and
/// counts: once for the two triangles of an inner edge.
bool is_negative(const MutableMesh& mesh, std::uint32_t t, Corner i, double cot,
                 const CouplingGoal& goal) {
  const auto& [v, n] = mesh.triangles[t];
  if (is_side(n[i])) return goal.weight > 0 && cot < mesh.sides[side_index(n[i])].least_cot;
  if (!goal.inside || n[i] < t) return false;
  const std::uint32_t from = v[i.previous()];
  const double sum = cot + mesh.cot_opposite(n[i], from);
  if (sum >= 0) return false;
  const MeshTriangle& other = mesh.triangles[n[i]];
  const bool given = mesh.is_given(v[0], v[1], v[2], other.v[other.edge_from(from)]);
  return sum < std::min(MutableMesh::least_sum(given), 0.0);
}

Shortfall sum_up(const MutableMesh& mesh, std::uint32_t t, const Goal& goal, bool with_fault) {
  const auto& n = mesh.triangles[t].n;
  const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
  const bool is_set = mesh.goal() == goal;
  std::array<Allowance, 3> other;  // by a goal that is not the one set
  SideAllowances sides{};
  for (const Corner i : kCorners) {
    if (!is_side(n[i])) continue;
    if (!is_set) other[i] = allowance_for(mesh.sides[side_index(n[i])], goal);
    sides[i] = is_set ? mesh.allowance(n[i]) : &other[i];
  }
  const double small = wanted_small(goal, sides);
  Shortfall shortfall;
  if (with_fault) shortfall.fault = fault_of(k, sides, goal);
  for (const Corner i : kCorners) {
    const double cot = k.cross > 0 ? k.dot[i] / k.cross : -kInverted;
    const double limit = wanted_large(goal, sides[i]);
    if (goal.coupling.weight > 0 && is_negative(mesh, t, i, cot, goal.coupling))
      ++shortfall.negative;
    shortfall.largest = std::max(shortfall.largest, -cot);
    shortfall.large = std::max(shortfall.large, -cot - limit);
    shortfall.is_far = shortfall.is_far || -cot > std::max(kFarAbove, limit) + kSameCot;
    if (!is_between_sides(sides, i)) shortfall.small = std::max(shortfall.small, cot - small);
  }
  return shortfall;
}

}  // namespace

Shortfall shortfall_of(const MutableMesh& mesh, std::uint32_t t, const Goal& goal) {
  return sum_up(mesh, t, goal, true);
}

Shortfall cots_short_of(const MutableMesh& mesh, std::uint32_t t, const Goal& goal) {
  return sum_up(mesh, t, goal, false);
}

}  // namespace cover
