// The stages for one region, cheapest first; each is left out once the goal is met.
//
// 1. Refine until angles are 24 degrees, which spreads vertices well but leaves angles of 132. With
//    less there are fewer vertices to begin with, but stages 2 to 4 take longer.
// 2. Improve both angles at once. Enough for most regions.
// 3. Where large angles are left: again with a weight for small angles so low that they decide only
//    between equals ("light"). Where many are left, small angles were in the way from the start:
//    then from the refined triangulation.
// 4. A triangle that is left is often held by neighbours that meet the goal just so. Rounds:
//    improve with a stricter goal in a zone around what is left, then with the goal itself; keep
//    what is better.
// 5. Thin out.
// Tested by tests/unit/quality/optimise_test.cpp.
#include "quality/optimise.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "quality/improve.hpp"
#include "quality/kicks.hpp"
#include "quality/refine.hpp"
#include "quality/thin_out.hpp"

namespace cover {
namespace {

constexpr double kLightWeight = 1e-4;    ///< of small angles in the light stage, times the goal's
constexpr double kManyAbove = 0.02;      ///< share of triangles above the goal that is many
constexpr std::size_t kSmallMesh = 200;  ///< triangles: kicks are cheap
constexpr double kRefinedTo = 24;        ///< degrees: more than asked for, see stage 1
constexpr std::size_t kMostSized = 50'000'000;  ///< vertices that sizes may ask for in a region
constexpr std::uint64_t kEvaluationsPerVertex = 100;  ///< more budget for what sizes add
constexpr std::uint64_t kFirstShare = 4;              ///< of the budget for stage 2: one in so many
constexpr int kRounds = 3;
constexpr int kRings = 3;                ///< of triangles around what is left, that make a zone
constexpr double kStricterLarge = 0.05;  ///< per round, in cotangents: 3 degrees
constexpr double kStricterSmall = 0.02;  ///< per round, relative

Goal light(Goal goal) {
  goal.weight *= kLightWeight;
  return goal;
}

void improve_within(MutableMesh& mesh, Budget& budget, std::vector<std::uint8_t> zone = {}) {
  budget.spend(improve(mesh, budget.left, std::move(zone)).evaluations);
}

/// Marks the vertices within kRings of a triangle with a positive excess.
std::vector<std::uint8_t> zone_around_excess(const MutableMesh& mesh) {
  std::vector<std::uint8_t> ring(mesh.points.size(),
                                 0);  // the ring number, counted down; 0: outside
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!(mesh.excess[t] > 0)) continue;
    for (const std::uint32_t v : mesh.triangles[t].v) ring[v] = kRings;
  }
  for (std::uint8_t r = kRings; r > 1; --r) {
    for (const MeshTriangle& t : mesh.triangles) {
      if (t.v[0] == kNone) continue;
      if (std::max({ring[t.v[0]], ring[t.v[1]], ring[t.v[2]]}) != r) continue;
      for (const std::uint32_t v : t.v) {
        if (ring[v] == 0) ring[v] = static_cast<std::uint8_t>(r - 1);
      }
    }
  }
  return ring;
}

/// Stage 4.
void improve_in_rounds(MutableMesh& mesh, const Goal& goal, const Goal& weighted, Merit& merit,
                       Budget& budget) {
  for (int round = 1; round <= kRounds && !merit.complete && !budget.is_used_up(); ++round) {
    const bool only_small = merit.above == 0;  // worth one round, with their full weight
    if (only_small && round > 1) break;
    const Goal& aim = only_small ? goal : weighted;
    MutableMesh saved = mesh;
    mesh.set_goal(aim);
    auto zone = zone_around_excess(mesh);
    mesh.set_goal(
        {aim.large - kStricterLarge * round, aim.small * (1 - kStricterSmall * round), aim.weight});
    improve_within(mesh, budget, std::move(zone));
    mesh.set_goal(aim);
    improve_within(mesh, budget);
    const Merit now = merit_of(mesh, goal);
    if (is_better(now, merit)) {
      merit = now;
    } else {
      mesh = std::move(saved);
    }
  }
}

}  // namespace

Merit optimise(MutableMesh& mesh, const Goal& goal, Budget& budget, const SizeField& sizes) {
  mesh.set_goal(goal);
  RefineLimits limits;
  limits.smallest_cot = 1 / std::tan(kRefinedTo * std::numbers::pi / 180);
  limits.budget = sizes.is_active() ? kMostSized : 20 * mesh.points.size() + 1000;
  refine(mesh, limits, sizes);
  if (sizes.is_active()) {
    budget.left += kEvaluationsPerVertex * (mesh.points.size() - mesh.fixed_vertices());
  }
  MutableMesh refined = mesh;
  Budget part = budget.share(kFirstShare);
  improve_within(mesh, part);
  budget.left += part.left;
  Merit merit = merit_of(mesh, goal);
  Goal weighted = goal;
  if (merit.above > 0) {
    const bool many =
        static_cast<double>(merit.above) > kManyAbove * static_cast<double>(merit.triangles);
    MutableMesh other = many ? std::move(refined) : mesh;
    const Merit now = improve_largest(other, goal, budget);
    if (is_better(now, merit)) {
      merit = now;
      mesh = std::move(other);
      weighted = light(goal);
    }
  }
  improve_in_rounds(mesh, goal, weighted, merit, budget);
  mesh.set_goal(weighted);
  improve_by_kicks(mesh, goal, merit, budget);
  if (!sizes.is_active()) budget.spend(thin_out(mesh, budget.left).evaluations);
  return merit_of(mesh, goal);
}

Merit improve_largest(MutableMesh& mesh, const Goal& goal, Budget& budget) {
  mesh.set_goal(light(goal));
  improve_within(mesh, budget);
  Merit merit = merit_of(mesh, goal);
  if (mesh.triangle_count() <= kSmallMesh) improve_by_kicks(mesh, goal, merit, budget);
  return merit;
}

}  // namespace cover
