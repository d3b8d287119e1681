// See kicks.hpp. Tested by tests/unit/quality/optimise_test.cpp.
#include "quality/kicks.hpp"

#include <utility>

#include "geom/vector.hpp"
#include "quality/cavity.hpp"
#include "quality/excerpt.hpp"
#include "quality/improve.hpp"
#include "quality/polygon.hpp"

namespace cover {
namespace {

constexpr std::size_t kTriangles = 64;  ///< around the one that is kicked, that may change
constexpr double kStricter = 0.1;  ///< the goal that is tried first, in cotangents: 6 degrees less
constexpr std::uint64_t kCopied = 8;  ///< triangles copied in the time of one star evaluation

}  // namespace

bool kick(MutableMesh& mesh, std::uint32_t t, int kind) {
  Cavity cavity(mesh);
  Installed installed;
  if (kind == 0) {
    cavity.start(t);
    const Point a = mesh.corner(t, 0);
    const Vector to_b = mesh.corner(t, 1) - a, to_c = mesh.corner(t, 2) - a;
    return install_star(mesh, cavity, a + (1.0 / 3) * (to_b + to_c), installed);
  }
  const int i = (kind - 1) % 3;
  if (kind <= 3) {
    cavity.start(t);
    return cavity.grow(i) &&
           install_star(mesh, cavity, midpoint(mesh.corner(t, i), mesh.corner(t, next3(i))),
                        installed);
  }
  if (kind <= 6) {
    return !is_side(mesh.triangles[t].n[static_cast<std::size_t>(i)]) && mesh.flip(t, i);
  }
  const std::uint32_t v = mesh.triangles[t].v[static_cast<std::size_t>(i)];
  Patch patch;
  return !mesh.is_fixed(v) && cavity.start_star(v) &&
         min_max_polygon(mesh, cavity, kInverted, patch) < kInverted &&
         install_patch(mesh, cavity, patch, installed);
}

void improve_with_slack(MutableMesh& mesh, Budget& budget) {
  const Goal aim = mesh.goal();
  mesh.set_goal({aim.large - kStricter, aim.small * (1 - kStricter), aim.weight});
  budget.spend(improve(mesh, budget.left).evaluations);
  mesh.set_goal(aim);
  budget.spend(improve(mesh, budget.left).evaluations + mesh.triangles.size() / kCopied);
}

bool kick_and_improve(MutableMesh& mesh, const Goal& goal, Budget& budget) {
  const Merit before = merit_of(mesh, goal);
  for (int kind = 0; kind < kKinds && !budget.is_used_up(); ++kind) {
    MutableMesh trial = mesh;
    if (!kick(trial, 0, kind)) continue;
    improve_with_slack(trial, budget);
    const Merit now = merit_of(trial, goal);
    if (now.above > before.above || !is_better(now, before)) continue;
    mesh = std::move(trial);
    return true;
  }
  return false;
}

void improve_by_kicks(MutableMesh& mesh, const Goal& goal, Merit& merit, Budget& budget) {
  if (merit.above == 0) return;
  std::vector<std::uint32_t> queue;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (is_above(mesh, t, goal)) queue.push_back(t);
  }
  for (std::size_t head = 0; head < queue.size() && !budget.is_used_up(); ++head) {
    const std::uint32_t t = queue[head];
    if (!is_above(mesh, t, goal)) continue;
    const Excerpt excerpt(mesh, t, kTriangles);
    MutableMesh part = excerpt.mesh;
    if (!kick_and_improve(part, goal, budget)) continue;
    for (const std::uint32_t changed : excerpt.replace(mesh, part)) {
      if (is_above(mesh, changed, goal)) queue.push_back(changed);
    }
  }
  merit = merit_of(mesh, goal);
}

}  // namespace cover
