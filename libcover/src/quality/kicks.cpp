// See kicks.hpp. Tested by tests/unit/quality/optimise_test.cpp.
#include "quality/kicks.hpp"

#include <utility>

#include "geom/vector.hpp"
#include "quality/cavity.hpp"
#include "quality/improve.hpp"
#include "quality/polygon.hpp"

namespace cover {
namespace {

constexpr std::size_t kSmallMesh = 200;  ///< triangles: any number above the goal is worked on
constexpr std::size_t kFewAbove = 16;  ///< triangles above the goal that are worked on in any mesh
constexpr std::uint64_t kCopied = 8;   ///< triangles copied in the time of one star evaluation
constexpr int kKinds = 10;  ///< 1 centre, 3 edges to insert on, 3 to flip, 3 corners to remove

/// Changes `mesh` around triangle `t`, for better or worse. False if that kind does not apply.
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

}  // namespace

void improve_by_kicks(MutableMesh& mesh, const Goal& goal, Merit& merit, Budget& budget) {
  if (merit.triangles > kSmallMesh && merit.above > kFewAbove) return;
  for (bool better = true; better && merit.above > 0;) {
    better = false;
    for (std::uint32_t t = 0; t < mesh.triangles.size() && !budget.is_used_up(); ++t) {
      if (!is_above(mesh, t, goal)) continue;
      for (int kind = 0; kind < kKinds && merit.above > 0; ++kind) {
        MutableMesh trial = mesh;
        if (!kick(trial, t, kind)) continue;
        budget.spend(improve(trial, budget.left).evaluations + merit.triangles / kCopied);
        const Merit now = merit_of(trial, goal);
        if (!is_better(now, merit)) continue;
        merit = now;
        mesh = std::move(trial);
        better = true;
        break;
      }
    }
  }
}

}  // namespace cover
