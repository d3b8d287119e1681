// See merit.hpp. Tested by tests/unit/quality/fault/merit_test.cpp.
#include "quality/fault/merit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace cover {
namespace {

constexpr double kNear = 0.05;        ///< 3 degrees
constexpr double kAlikeFault = 1e-3;  ///< faults that differ by less are the same
constexpr double kAlike = 1.02;       ///< of cotangents above 140 degrees: of what is left to 180

/// Both miss the target by little.
bool are_near(const Merit& a, const Merit& b) {
  return std::min(a.large, b.large) > a.target + kSameCot &&
         std::max(a.large, b.large) <= a.target + kNear;
}

/// Largest angles from 120 to 130 degrees, and from there to 140, are alike, and so are those above
/// whose distances to 180 degrees are; unless one of them is the target.
bool are_alike(const Merit& a, const Merit& b) {
  constexpr double k130 = 0.8390996311772800;  // -cot
  const double least = std::min(a.large, b.large), most = std::max(a.large, b.large);
  if (least <= std::max(kFarAbove, a.target + kSameCot)) return false;
  if (least > kVeryFarAbove) return most <= kAlike * least;
  if (most > kVeryFarAbove) return false;
  return (least <= k130) == (most <= k130);
}

/// What is wrong with one triangle.
Merit merit_of_one(const Shortfall& shortfall, const Goal& goal) {
  const double fault = shortfall.fault.worst();
  Merit one;
  one.large = shortfall.largest;
  one.above = shortfall.is_above() ? 1 : 0;
  one.far_above = shortfall.is_far ? 1 : 0;
  one.small = goal.weight > 0 ? goal.small + shortfall.small : -kInverted;
  one.complete = !shortfall.is_above() && !shortfall.is_below(goal) && shortfall.negative == 0;
  one.fault = shortfall.fault;
  one.sum = fault;
  one.missed = fault > 0 ? 1 : 0;
  one.negative = shortfall.negative;
  return one;
}

/// Adds what is wrong with the triangles from `first` to `last` to a merit without faults.
void add_faults(const MutableMesh& mesh, const Goal& goal, std::size_t first, std::size_t last,
                Merit& merit) {
  // What has no excess meets the goal, whatever its couplings weigh.
  const bool is_measured = mesh.goal().has_same_angles(goal) &&
                           mesh.goal().coupling.inside == goal.coupling.inside &&
                           (mesh.goal().coupling.weight > 0) == (goal.coupling.weight > 0);
  for (std::size_t k = first; k < last; ++k) {
    const auto t = static_cast<std::uint32_t>(k);
    if (mesh.is_hole(t) || (is_measured && mesh.excess[t] <= 0)) continue;
    merit.add(merit_of_one(shortfall_of(mesh, t, goal), goal));
  }
}

/// The largest -cot of an apex that a side forces.
double largest_forced(const MutableMesh& mesh, const Team& team) {
  std::vector<double> largest(Team::ranges(mesh.sides.size(), kFewAtATime), -kInverted);
  team.each_range(mesh.sides.size(), kFewAtATime, [&](std::size_t first, std::size_t last) {
    double& own = largest[first / kFewAtATime];
    for (std::size_t s = first; s < last; ++s) own = std::max(own, -mesh.sides[s].apex_cot);
  });
  return largest.empty() ? -kInverted : *std::max_element(largest.begin(), largest.end());
}

}  // namespace

void Merit::add(const Merit& more) {
  large = std::max(large, more.large);
  small = std::max(small, more.small);
  above += more.above;
  far_above += more.far_above;
  fault.wide = std::max(fault.wide, more.fault.wide);
  fault.narrow = std::max(fault.narrow, more.fault.narrow);
  sum += more.sum;
  missed += more.missed;
  negative += more.negative;
  complete = complete && more.complete;
}

Merit merit_of(const MutableMesh& mesh, const Goal& goal, const Team& team) {
  Merit merit{goal.large, goal.large, 0, 0, goal.small, mesh.triangle_count(), true, {}, 0, 0, 0};
  if (mesh.triangles.size() <= kItemsAtATime) {  // no lists of one
    for (const SideLimit& side : mesh.sides) merit.target = std::max(merit.target, -side.apex_cot);
    merit.large = merit.target;
    add_faults(mesh, goal, 0, mesh.triangles.size(), merit);
    return merit;
  }
  merit.target = merit.large = std::max(goal.large, largest_forced(mesh, team));
  std::vector<Merit> parts(Team::ranges(mesh.triangles.size(), kItemsAtATime), merit);
  team.each_range(mesh.triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    add_faults(mesh, goal, first, last, parts[first / kItemsAtATime]);
  });
  for (const Merit& part : parts) merit.add(part);
  return merit;
}

bool is_above(const MutableMesh& mesh, std::uint32_t t, const Goal& goal) {
  return !mesh.is_hole(t) && cots_short_of(mesh, t, goal).is_above();
}

bool is_smaller_cot(double a, double b) { return a < b - kSameCot * std::max(1.0, std::abs(b)); }

bool is_better_by_largest(const Merit& a, const Merit& b) {
  const bool is_same = !is_smaller_cot(a.large, b.large) && !is_smaller_cot(b.large, a.large);
  const bool is_near = are_near(a, b);
  if (!is_same && !is_near && !are_alike(a, b)) return a.large < b.large;
  if (a.far_above != b.far_above) return a.far_above < b.far_above;
  if (is_near && a.above != b.above) return a.above < b.above;
  if (!is_same) return a.large < b.large;
  if (a.above != b.above) return a.above < b.above;
  if (is_smaller_cot(a.small, b.small) || is_smaller_cot(b.small, a.small)) {
    return a.small < b.small;
  }
  return a.triangles < b.triangles;
}

bool Order::is_better(const Merit& a, const Merit& b) const {
  const bool is_within = is_within_bound(a);
  if (is_within != is_within_bound(b)) return is_within;
  if (a.negative != b.negative) return a.negative < b.negative;
  if (prefer == Prefer::largest) return is_better_by_largest(a, b);
  const auto steps = [](double fault) { return std::lround(fault / kAlikeFault); };
  const auto key = [&](const Merit& m) {
    const long fault = steps(m.fault.worst());
    return std::tuple(m.fault.worst() > degenerate ? fault : 0, m.far_above, fault, m.missed, m.sum,
                      m.triangles);
  };
  return key(a) < key(b);
}

}  // namespace cover
