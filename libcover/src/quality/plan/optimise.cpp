// Step 5 of docs/quality_method.md (refine, improve, search, thin out), cheapest first, each left
// out once the goal is met; and step 6 (couplings), where these count.
//
// Refinement to 24.5 degrees leaves angles of 131. With less there are fewer vertices to begin
// with, but improvement, and what comes after, takes longer. It goes up to 33 degrees where less
// than 100 are asked for: else thousands of angles are left on large regions, which no search
// mends.
//
// Where many large angles are left, small angles were in the way from the start: improved once more
// from the refined triangulation, with a weight for small angles so low that they decide only
// between equals ("light"). Only with all effort. In tiny regions random restarts do better than
// the search.
// Tested by tests/unit/quality/plan/optimise_test.cpp.
#include "quality/plan/optimise.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geom/cotangent.hpp"
#include "quality/effort/effort.hpp"
#include "quality/fault/extreme_angles.hpp"
#include "quality/fault/keep_rules.hpp"
#include "quality/repair/improve.hpp"
#include "quality/repair/search.hpp"
#include "quality/repair/thin_out.hpp"
#include "quality/starts/delaunay_refinement.hpp"
#include "target/refine_budget.hpp"

namespace cover {
namespace {

constexpr double kLightSmall = 4;         ///< times the goal's cotangent, when light: 5 degrees
constexpr double kRefinedTo = 24.5;       ///< degrees: more than asked for, see above,
constexpr double kRefinedFurther = 0.75;  ///< and so much for each below 100,
constexpr double kRefinedAtMost = 33;     ///< from 34 on refinement may not end

/// Evaluations for a triangle, where all that is left may be spent.
constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint32_t>::max();

Goal light(Goal goal) {
  goal.weight *= kLightWeight;
  goal.small *= kLightSmall;
  return goal;
}

void improve_within(MutableMesh& mesh, Budget& budget, const Sharing& sharing,
                    std::span<const double> known = {}, Before before = Before::nothing) {
  const ImproveResult result = improve(mesh, budget.left, known, sharing, before);
  budget.spend(result.evaluations);
  budget.was_too_small = budget.was_too_small || result.budget_used_up;
}

/// Whether at most `share` of the triangles are above the goal.
bool has_at_most(const Merit& merit, double share) {
  return static_cast<double>(merit.above) <= share * static_cast<double>(merit.triangles);
}

/// Whether a large mesh misses so little that a search for all of it takes little beside what has
/// been done.
bool is_nearly_clean(const Merit& merit) {
  return merit.triangles > effort::kSearchedInAnyCase && merit.missed > 0 &&
         static_cast<double>(merit.missed) <=
             effort::kFewMissed * static_cast<double>(merit.triangles);
}

/// Where much is left, it is so for reasons that no search changes; but in small meshes all can be
/// tried.
bool is_worth_a_search(const Merit& merit) {
  return merit.triangles <= effort::kSearchedInAnyCase ||
         has_at_most(merit, effort::kShareWithoutHope);
}

bool is_thorough(SearchAfter how_hard) {
  return how_hard == SearchAfter::hope || how_hard == SearchAfter::all;
}

/// What may be spent on each triangle after refinement.
std::uint64_t improve_evaluations(SearchAfter how_hard, bool is_tiny) {
  return is_thorough(how_hard)              ? kUnlimited
         : how_hard == SearchAfter::nothing ? effort::kImproveFast
         : is_tiny                          ? effort::kImproveTiny
                                            : effort::kImprovePerTriangle;
}

/// Improvement: with a part of what is left, and no more than `each` for a triangle. What is
/// left undone then is for what follows.
void improve_refined(MutableMesh& mesh, std::uint64_t each, Budget& budget,
                     const Sharing& sharing) {
  const std::uint64_t part = budget.left / effort::kImprovementsPart;
  budget.within(
      std::min(part, each * mesh.triangle_count()), [&] { improve_within(mesh, budget, sharing); },
      WhenTooSmall::is_kept);
}

/// What may be spent on each triangle when couplings have become heavier.
std::uint64_t coupling_evaluations(SearchAfter how_hard) {
  return how_hard == SearchAfter::nothing ? effort::kCoupleFast
         : how_hard == SearchAfter::few   ? effort::kCouplePerTriangle
                                          : kUnlimited;
}

/// Whether what is left is searched, after couplings had their say.
bool is_due(SearchAfter how_hard, const Merit& merit) {
  if (is_thorough(how_hard)) return is_worth_a_search(merit);
  const bool are_few = merit.triangles <= effort::kSmallMesh && merit.missed > 0 &&
                       merit.missed <= effort::kFewInSmall;
  return how_hard == SearchAfter::few && (is_nearly_clean(merit) || are_few);
}

/// The smallest angle to which is refined. A star of 1e5 points ends with 77,000 angles above
/// the 90 degrees asked for if that is 36 degrees, with 59 if it is 30, and with none if it is 32.
Angle refined_to(const Goal& goal) {
  const double below = 100 - Angle::radians(angle_of_cot(-goal.large)).in_degrees();
  return Angle::degrees(
      std::clamp(kRefinedTo + kRefinedFurther * below, kRefinedTo, kRefinedAtMost));
}

RefineLimits refine_limits(const MutableMesh& mesh, const Goal& goal, bool has_sizes) {
  RefineLimits limits;
  limits.keeps_couplings = goal.coupling.weight > 0;
  limits.smallest_cot = cot_of(refined_to(goal).in_radians());
  limits.budget = has_sizes ? effort::kMostSizedVertices : refine_budget(mesh.points.size());
  return limits;
}

/// The couplings of sides, beside angles.
Goal with_sides(Goal goal) {
  if (goal.coupling.weight > 0) goal.coupling = {.weight = 1, .bound = kInverted};
  return goal;
}

/// The couplings of all edges, beside angles.
Goal with_edges(Goal goal) {
  goal.coupling = {.weight = 1, .inside = true, .bound = kInverted};
  return goal;
}

/// Makes a triangulation constrained Delaunay, at the price of angles, and improves it again with
/// couplings before angles.
///
/// REQUIRES: `mesh` is improved
/// ENSURES:  returns what was reached, by `goal`; no coupling that counts is negative but for those
///           that the bound needs
/// Cost:     improvement takes `each` evaluations for each triangle, once or twice
Merit mind_couplings(MutableMesh& mesh, const Goal& goal, Budget& budget, SearchAfter how_hard,
                     const Sharing& sharing, std::uint64_t each) {
  const bool was_met = std::all_of(mesh.excess.begin(), mesh.excess.end(),
                                   [](double excess) { return excess <= kLeastCoupling; });
  UnsetVector<double> known = copy_of(mesh.excess, sharing.team);
  const auto flip_and_improve = [&](const Goal& aim) {
    mesh.set_goal(aim, sharing.team);
    budget.within(
        each * mesh.triangle_count(),
        [&] { improve_within(mesh, budget, sharing, known, Before::flips_to_delaunay); },
        WhenTooSmall::is_kept);
    known = copy_of(mesh.excess, sharing.team);
    return merit_of(mesh, aim, sharing.team);
  };
  // Flips may pass through what is not Delaunay as long as couplings weigh no more than angles.
  const Goal soft = with_edges(goal);
  Merit merit = flip_and_improve(soft);
  // What is missed beside something that is forced is mostly forced as well.
  const bool is_near =
      merit.fault.worst() <= effort::kNearMiss && (is_thorough(how_hard) || mesh.is_unforced());
  if ((was_met || is_near) && is_due(how_hard, merit)) {
    const bool is_small = merit.triangles <= effort::kSmallMesh && !is_thorough(how_hard);
    const std::uint64_t one_more =
        is_small ? effort::kSearchForOneMore : effort::kSearchForCouplings;
    const std::uint64_t first = is_small ? std::min(effort::kSearchForCouplings,
                                                    effort::kSearchPerTriangle * merit.triangles)
                                         : effort::kSearchForCouplings;
    MutableMesh start;
    if (is_small) start = mesh;
    budget.within(
        first + one_more * (std::max<std::size_t>(merit.missed, 1) - 1),
        [&] { search_excerpts(mesh, soft, budget, Restarts::none, sharing); },
        WhenTooSmall::is_kept);
    const Merit found = merit_of(mesh, soft, sharing.team);
    if (is_small && !is_kept_beside_couplings(found, merit)) {
      mesh = std::move(start);
    } else {
      known.clear();
      merit = found;
    }
  }
  if (merit.complete) return merit;
  merit = flip_and_improve(goal);
  if (!is_due(how_hard, merit) || (!was_met && merit.triangles <= effort::kSearchedInAnyCase))
    return merit;
  search_excerpts(mesh, goal, budget, Restarts::none, sharing);
  return merit_of(mesh, goal, sharing.team);
}

}  // namespace

Optimised optimise(MutableMesh& mesh, const Goal& asked, Budget& budget, const HowToOptimise& how) {
  const SizeField none;
  const SizeField& sizes = how.sizes != nullptr ? *how.sizes : none;
  const Sharing& sharing = how.sharing;
  SearchAfter how_hard = how.search;
  const Goal goal = with_sides(asked);
  const bool is_tiny = mesh.fixed_vertices() <= kTinyRegion && !sizes.is_active();
  mesh.set_goal_unmeasured(goal, sharing.team);  // what is refined is measured in the end
  const RefineLimits limits = refine_limits(mesh, goal, sizes.is_active());
  const bool may_start_again = is_thorough(how_hard);
  MutableMesh start;  // a third of what it becomes: to be refined again is rare
  if (may_start_again) start = mesh;
  refine(mesh, limits, sizes, sharing);
  if (sizes.is_active()) {
    budget.left += effort::kBudgetPerSizedVertex * (mesh.points.size() - mesh.fixed_vertices());
  }
  improve_refined(mesh, improve_evaluations(how_hard, is_tiny), budget, sharing);
  Merit merit = merit_of(mesh, goal, sharing.team);
  if (may_start_again && !has_at_most(merit, effort::kShareToStartAgain)) {
    refine(start, limits, sizes, sharing);
    start.set_goal(light(goal), sharing.team);
    improve_refined(start, kUnlimited, budget, sharing);
    const Merit now = merit_of(start, goal, sharing.team);
    if (how.order.is_better(now, merit)) {
      merit = now;
      mesh = std::move(start);
    }
  }
  if (how_hard == SearchAfter::few && is_nearly_clean(merit)) how_hard = SearchAfter::all;
  if (how_hard == SearchAfter::all && has_at_most(merit, effort::kShareWorthMore)) {
    budget.left += effort::kMoreForEach * std::min(merit.above, effort::kMostWorthMore);
  }
  if (is_thorough(how_hard) && !is_tiny && is_worth_a_search(merit))
    search_excerpts(mesh, goal, budget, Restarts::none, sharing);
  if (!sizes.is_active()) budget.spend(thin_out(mesh, budget.left, sharing).evaluations);
  if (goal == asked) return {merit_of(mesh, goal, sharing.team), std::nullopt};
  const AngleRange before_couplings = extreme_angles(mesh, sharing.team);
  return {mind_couplings(mesh, asked, budget, is_tiny ? SearchAfter::nothing : how_hard, sharing,
                         coupling_evaluations(how_hard)),
          before_couplings};
}

Merit improve_largest(MutableMesh& mesh, const Goal& goal, Budget& budget, const Sharing& sharing) {
  mesh.set_goal(light(goal), sharing.team);
  improve_within(mesh, budget, sharing);
  const Merit merit = merit_of(mesh, goal, sharing.team);
  if (merit.triangles > effort::kSearchedForEachCandidate || !is_worth_a_search(merit))
    return merit;
  search_excerpts(mesh, goal, budget);
  return merit_of(mesh, goal, sharing.team);
}

}  // namespace cover
