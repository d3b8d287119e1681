// See kicks.hpp. Tested by tests/unit/quality/repair/kicks_test.cpp.
#include "quality/repair/kicks.hpp"

#include <utility>

#include "quality/effort/effort.hpp"
#include "quality/fault/keep_rules.hpp"
#include "quality/moves/kick.hpp"
#include "quality/parts/excerpt.hpp"
#include "quality/repair/improve.hpp"

namespace cover {
namespace {

constexpr double kStricter = 0.1;  ///< the goal that is tried first, in cotangents: 6 degrees less

}  // namespace

void improve_with_slack(MutableMesh& mesh, Budget& budget) {
  const Goal aim = mesh.goal();
  mesh.set_goal(aim.with(aim.large - kStricter, aim.small * (1 - kStricter), aim.weight));
  budget.spend(improve(mesh, budget.left).evaluations);
  mesh.set_goal(aim);
  budget.spend(improve(mesh, budget.left).evaluations +
               mesh.triangles.size() / effort::kCopiedPerEvaluation);
}

bool kick_and_improve(MutableMesh& mesh, const Goal& goal, Budget& budget) {
  const Merit before = merit_of(mesh, goal);
  for (const Kick kick : kKicks) {
    if (budget.is_used_up()) break;
    MutableMesh trial = mesh;
    if (!do_kick(trial, 0, kick)) continue;
    improve_with_slack(trial, budget);
    const Merit now = merit_of(trial, goal);
    if (!is_kick_kept(now, before)) continue;
    mesh = std::move(trial);
    return true;
  }
  return false;
}

Merit improve_by_kicks(MutableMesh& mesh, const Goal& goal, const Merit& before, Budget& budget) {
  if (before.above == 0) return before;
  std::vector<std::uint32_t> queue;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (is_above(mesh, t, goal)) queue.push_back(t);
  }
  for (std::size_t head = 0; head < queue.size() && !budget.is_used_up(); ++head) {
    const std::uint32_t t = queue[head];
    if (!is_above(mesh, t, goal)) continue;
    const Excerpt excerpt(mesh, t, effort::kExcerpt);
    MutableMesh trial = excerpt.mesh;
    if (!kick_and_improve(trial, goal, budget)) continue;
    for (const std::uint32_t changed : excerpt.replace(mesh, trial)) {
      if (is_above(mesh, changed, goal)) queue.push_back(changed);
    }
  }
  return merit_of(mesh, goal);
}

}  // namespace cover
