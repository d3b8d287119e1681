// See kicks.hpp. Tested by tests/unit/quality/repair/kicks_test.cpp.
#include "quality/repair/kicks.hpp"

#include <optional>
#include <utility>

#include "quality/effort/effort.hpp"
#include "quality/fault/keep_rules.hpp"
#include "quality/moves/kick.hpp"
#include "quality/parts/excerpt.hpp"
#include "quality/repair/improve.hpp"
#include "quality/repair/triangles_above.hpp"

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
  TrianglesAbove above(mesh, goal);
  while (!above.empty() && !budget.is_used_up()) {
    const std::optional<std::uint32_t> t = above.next();
    if (!t) continue;
    const Excerpt excerpt(mesh, *t, effort::kExcerpt);
    MutableMesh trial = excerpt.mesh;
    if (kick_and_improve(trial, goal, budget)) above.add(excerpt.replace(mesh, trial));
  }
  return merit_of(mesh, goal);
}

}  // namespace cover
