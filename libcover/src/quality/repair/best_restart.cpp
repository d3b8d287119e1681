// Every other restart leaves small angles out: beside a side that is very short, even the lightest
// weight makes them count for more.
#include "quality/repair/best_restart.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "quality/repair/improve_jointly.hpp"
#include "quality/starts/restart.hpp"

namespace cover {
namespace {

constexpr std::uint32_t kStarts = 27;         ///< where the target for large angles is missed
constexpr std::uint32_t kStartsForSmall = 6;  ///< as soon as only small ones are left
constexpr std::array<double, 3> kPolished{0.2, 0.04, 0.008};  ///< of what is missed: last aims

}  // namespace

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
