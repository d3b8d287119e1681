// A place is drawn in a triangle that is drawn first: where triangles are small there is much to be
// decided. Places keep their barycentric coordinates, so scaled by a power of two they are the
// same places. Every other restart of those for the largest angle leaves small angles out: beside
// a side that is very short, even the lightest weight makes them count for more.
// Tested by tests/unit/quality/starts/restart_test.cpp.
#include "quality/starts/restart.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "cdt/cdt.hpp"
#include "cdt/region_cdt.hpp"
#include "cdt/sides.hpp"
#include "geom/vector.hpp"
#include "quality/repair/improve_jointly.hpp"

namespace cover {
namespace {

constexpr std::uint32_t kStarts = 27;         ///< where the target for large angles is missed
constexpr std::uint32_t kStartsForSmall = 6;  ///< as soon as only small ones are left
constexpr std::array<double, 3> kPolished{0.2, 0.04, 0.008};  ///< of what is missed: last aims

/// A side and its number.
using NumberedSide = std::pair<IndexPair, std::uint32_t>;

std::vector<NumberedSide> sides_in_order(const MutableMesh& mesh) {
  std::vector<NumberedSide> sides;
  for (const MeshTriangle& t : mesh.triangles) {
    if (t.v[0] == kNone) continue;
    for (const Corner i : kCorners) {
      if (is_side(t.n[i]))
        sides.push_back({{t.v[i.next()], t.v[i.previous()]}, side_index(t.n[i])});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

std::optional<MutableMesh> restart(const MutableMesh& mesh, std::size_t count,
                                   std::uint32_t number) {
  const std::uint32_t fixed = mesh.fixed_vertices();
  std::vector<Point> points(mesh.points.begin(), mesh.points.begin() + fixed);
  std::vector<std::uint32_t> present;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.is_hole(t)) present.push_back(t);
  }
  Random random(number);
  for (std::size_t k = 0; k < count; ++k) {
    const auto drawn =
        static_cast<std::size_t>(random.unit() * static_cast<double>(present.size()));
    double u = random.unit(), v = random.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Point a = mesh.corner(present[drawn], 0);
    const Vector to_b = mesh.corner(present[drawn], 1) - a,
                 to_c = mesh.corner(present[drawn], 2) - a;
    points.push_back(a + u * to_b + v * to_c);
  }

  const std::vector<NumberedSide> sides = sides_in_order(mesh);
  std::vector<IndexPair> pairs;
  for (const auto& [pair, side] : sides) pairs.push_back(pair);
  const CdtResult cdt = triangulate_domain(points, pairs);
  if (find_fault(cdt, points, pairs)) return std::nullopt;  // rounding put a place outside
  const std::vector<EdgeRef> found = locate_sides(cdt.triangulation, pairs);
  std::vector<EdgeRef> side_at(mesh.sides.size());
  for (std::size_t k = 0; k < sides.size(); ++k) {
    side_at[sides[k].second] = found[k];
  }
  MutableMesh result(cdt.triangulation, fixed, side_at, mesh.sides);
  result.set_goal(mesh.goal());
  return result;
}

Restarted best_restart(const MutableMesh& mesh, const Merit& before, const Goal& goal,
                       double ceiling, Budget& budget) {
  Restarted best{mesh, before};
  const Merit& merit = best.merit;
  /// Improves `trial` with the largest angle first, down to -cot `aim`; keeps it if it is better.
  const auto try_it = [&](MutableMesh trial, double aim, double light) {
    trial.set_goal(goal.with(aim, goal.small, light * goal.weight));
    budget.spend(improve(trial, budget.left).evaluations);
    improve_jointly(trial, budget, [] { return false; });
    trial.set_goal(goal);
    const Merit reached = merit_of(trial, goal);
    if (is_smaller_cot(ceiling, reached.large) || !is_better_by_largest(reached, merit)) return;
    best = {std::move(trial), reached};
  };

  // What is aimed at, in turn: the region's own target; the goal; few triangles above 120 degrees.
  const std::array<double, 3> aims{merit.target, goal.large,
                                   std::max(goal.large, std::min(kFarAbove, merit.target))};
  const auto only_small_are_left = [&] {
    return merit.above == 0 && !is_smaller_cot(merit.target, merit.large);
  };
  const bool only_small = only_small_are_left();
  for (std::uint32_t k = 0; k < kStarts && !budget.is_used_up(); ++k) {
    if (k >= kStartsForSmall && only_small_are_left()) break;
    std::optional<MutableMesh> start = restart(mesh, 1 + k / aims.size() % 3, k);
    budget.spend(kRestartCost);
    if (start)
      try_it(*std::move(start), aims[k % aims.size()] - kAimBelow,
             only_small || k % 2 == 0 ? kLightWeight : 0);
  }
  // Steps count by what they win of an excess: near the aim, small ones do.
  for (const double part : kPolished) {
    if (!is_smaller_cot(merit.target, merit.large) || budget.is_used_up()) break;
    try_it(best.mesh, merit.large - part * (merit.large - merit.target), 0);
  }
  return best;
}

}  // namespace cover
