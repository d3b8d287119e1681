// See plan.hpp. Tested by tests/unit/quality/plan/plan_test.cpp.
#include "quality/plan/plan.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "options/intent.hpp"
#include "quality/effort/effort.hpp"

namespace cover {
namespace {

using StopWhen = Step::StopWhen;

/// The steps of one plan, then those of another.
template <std::size_t kFirst, std::size_t kSecond>
constexpr std::array<Step, kFirst + kSecond> joined(const std::array<Step, kFirst>& first,
                                                    const std::array<Step, kSecond>& second) {
  std::array<Step, kFirst + kSecond> all{};
  std::copy(first.begin(), first.end(), all.begin());
  std::copy(second.begin(), second.end(), all.begin() + kFirst);
  return all;
}

bool always(const PlanProgress&) { return true; }
bool has_room_for_one_star(const PlanProgress& p) { return p.make.has_room_for_one_star(); }
bool is_missed(const PlanProgress& p) { return !p.best.merit.complete; }
bool is_tiny_and_missed(const PlanProgress& p) { return p.make.is_tiny() && is_missed(p); }
bool has_far(const PlanProgress& p) { return p.best.merit.far_above > 0; }
/// Nothing is made of a region without room for a vertex.
bool refined_has_far(const PlanProgress& p) { return has_far(p) && p.refined.merit.triangles > 0; }
bool is_tiny_and_near(const PlanProgress& p) {
  return is_tiny_and_missed(p) && p.cdt.mesh->fixed_vertices() >= effort::kPointsToRestart &&
         p.best.merit.fault.worst() <= effort::kNearMiss &&
         !p.make.outlook().is_near_limits(p.best);
}
bool is_tiny_and_very_wide(const PlanProgress& p) {
  return is_tiny_and_missed(p) && has_far(p) && p.best.merit.large > kVeryFarAbove;
}
/// So few that they are likely to be mended; in tiny regions nothing is.
bool few_are_missed(const PlanProgress& p) {
  const Merit& merit = p.best.merit;
  return !p.make.is_tiny() && merit.triangles <= effort::kSmallMesh && merit.missed > 0 &&
         merit.missed <= effort::kFewInSmall &&
         merit.fault.worst() <= effort::kFaultImprovedAgain &&
         !p.make.outlook().is_near_limits(p.best);
}
/// So few, by so little, that a search of the whole mesh pays.
bool nearly_none_is_missed(const PlanProgress& p) {
  const Merit& merit = p.best.merit;
  return merit.missed <= effort::kSearchedAgain && merit.sum <= effort::kFaultImprovedAgain &&
         p.cdt.mesh->is_unforced() && few_are_missed(p);
}
bool is_beyond_bound(const PlanProgress& p) { return !p.make.ranking().is_within_bound(p.best); }
/// Only almonds hold it then, which know no sizes; the rest beside layers gets none.
bool would_give_sizes_up(const PlanProgress& p) { return is_beyond_bound(p) && !p.make.is_rest(); }
bool refined_is_beyond_bound(const PlanProgress& p) {
  return !p.make.ranking().is_within_bound(p.refined);
}
bool is_missed_by_largest(const PlanProgress& p) { return !p.make.is_done(p.best); }

/// So few points that the best may have been found, and nothing but the targets is missed.
bool may_be_near(const PlanProgress& p) {
  return p.cdt.mesh->fixed_vertices() <= effort::kPointsToBeNear && p.best.merit.negative == 0 &&
         !is_beyond_bound(p);
}

bool has_couplings(const PlanProgress& p) { return p.make.goal().coupling.weight > 0; }

bool is_star_taken(const PlanProgress& p) {
  return p.best.merit.triangles != p.cdt.merit.triangles;
}

/// Room for more than one vertex, or at least for one that is better than none.
bool may_have_room(const PlanProgress& p) {
  return !has_couplings(p) || p.cdt.mesh->fixed_vertices() > effort::kPointsOfOneRoom ||
         is_star_taken(p) || is_beyond_bound(p);
}

/// With little effort less room is believed in.
bool may_have_much_room(const PlanProgress& p) {
  const std::uint32_t points = p.cdt.mesh->fixed_vertices();
  return is_beyond_bound(p) || points > effort::kPointsOfFewRooms ||
         (is_star_taken(p) && points > effort::kPointsOfOneRoom);
}

/// A large angle is left to the plain triangulation, for whatever was tried came to negative
/// couplings. Beyond the bound almonds are better.
bool is_plain_and_above(const PlanProgress& p) {
  return has_couplings(p) && may_have_room(p) && p.best.merit.above > 0 && !is_beyond_bound(p) &&
         p.best.mesh->points.size() == p.cdt.mesh->points.size();
}

void take(PlanProgress& p, Candidate other) {
  p.make.ranking().take_if_better(p.best, std::move(other));
}

void as_it_is(PlanProgress& p) {
  p.cdt = p.best = p.make.as_it_is();
  p.make.compare_with(p.cdt);
  if (!p.make.has_sizes() && !p.cdt.merit.complete) p.make.look_for_room(p.cdt);
}
void one_star(PlanProgress& p) {
  p.star = p.make.one_star(p.cdt);
  if (p.star && p.star->merit.complete) p.best = *p.star;
}
void best_star(PlanProgress& p) {
  one_star(p);
  if (p.star) take(p, *p.star);
}
/// What is near its limits is not searched; the answer counts for the report, too.
void limits(PlanProgress& p) { p.is_settled = p.make.outlook().is_settled(p.best, p.make.goal()); }
/// Where only couplings of sides keep it from being taken, without the vertices in their way, too.
void take_refined(PlanProgress& p) {
  if (p.refined.merit.negative > p.best.merit.negative) take(p, p.make.giving_way(p.refined));
  take(p, p.refined);
}
void refined(PlanProgress& p) {
  p.refined = p.make.optimised(p.cdt, SearchAfter::nothing);
  take_refined(p);
}
void refined_and_searched(PlanProgress& p) {
  p.refined = p.make.optimised(p.cdt, SearchAfter::few);
  take_refined(p);
}
void refined_and_searched_all(PlanProgress& p) {
  p.refined = p.make.optimised(p.cdt, SearchAfter::all);
  take_refined(p);
}
/// By the largest angle, no vertex gives way to couplings.
void largest_refined(PlanProgress& p) {
  p.refined = p.make.optimised(p.cdt, SearchAfter::all);
  take(p, p.refined);
}
void refined_and_searched_again(PlanProgress& p) {
  const std::uint64_t most =
      p.best.merit.triangles *
      (has_couplings(p) ? effort::kSearchedCoupled : effort::kSearchedPerTriangle);
  p.refined = p.make.optimised_within(p.cdt, SearchAfter::hope, most);
  take(p, p.refined);
}
void sized(PlanProgress& p) { p.best = p.refined = p.make.optimised(p.cdt, SearchAfter::nothing); }
void sized_and_searched(PlanProgress& p) {
  p.best = p.refined = p.make.optimised(p.cdt, SearchAfter::few);
}
void sized_and_searched_all(PlanProgress& p) {
  p.best = p.refined = p.make.optimised(p.cdt, SearchAfter::all);
}
Candidate narrowed_to_bound(const PlanProgress& p, const Candidate& from) {
  return p.make.narrowed(p.best, from, p.make.ranking().order().bound, effort::kNarrowedToBound);
}
void within_bound(PlanProgress& p) { p.best = narrowed_to_bound(p, p.refined); }
/// What couplings and small angles pay before sizes are given up; the best as it is if that does
/// not lead within the bound.
Candidate at_any_price(const PlanProgress& p) {
  Ranking& ranking = p.make.ranking();
  Order order = ranking.order();
  order.degenerate = 1;  // none counts before the angles above 120 degrees
  ranking.set_order(order);
  const double bound = order.bound;
  const auto narrow = [&](Candidate found, std::span<const double> parts) {
    if (ranking.is_within_bound(found)) return found;
    return p.make.narrowed(found, p.refined, bound, effort::kNarrowedToBound, parts);
  };
  Candidate found = p.best;
  if (has_couplings(p)) found = narrow(std::move(found), effort::kSmallestParts);
  found = narrow(std::move(found), effort::kDegenerateParts);
  if (!ranking.is_within_bound(found)) return p.best;
  ranking.take_if_better(found, p.make.improved(found));  // the bound was all that it aimed at
  return found;
}
void within_bound_before_sizes(PlanProgress& p) {
  if (p.make.ranking().is_within_bound(p.cdt) && p.make.keeps_sizes(p.cdt))
    p.best = p.make.improved(p.cdt);
  else
    p.best = p.make.with_goal(p.make.goal_below_bound(), [&] { return at_any_price(p); });
}
void with_fewer_far(PlanProgress& p) {
  p.best = p.make.narrowed(p.best, p.refined, kFarAbove, effort::kNarrowedToFewerFar);
}
void restarted(PlanProgress& p) { take(p, p.make.restarted(p.best)); }
/// Where sides force small angles all over, vertices that were to mend these stood in the way. One
/// more small angle beside worse ones is no reason to keep a large one then.
void searched_for_large(PlanProgress& p) {
  const Goal& goal = p.make.goal();
  Candidate found =
      p.make.searched(p.best, goal.with(goal.large, goal.small, 0), effort::kSearchForLarge);
  const Merit &was = p.best.merit, &is = found.merit;
  if (is.large > was.large) return;
  if (is.above < was.above && is.negative == 0 && is.fault.worst() <= was.fault.worst() &&
      is.small <= was.small) {
    p.best = std::move(found);
  } else {
    take(p, std::move(found));
  }
}
void improved(PlanProgress& p) { take(p, p.make.improved(p.best)); }
void evenly_refined(PlanProgress& p) {
  const std::optional<Candidate> even = p.make.evenly_refined(p.cdt);
  if (even) take(p, p.make.improved(*even));
}
void star_improved(PlanProgress& p) {
  if (!p.make.has_room_for_one_star()) p.star = p.make.one_star(p.cdt);
  if (p.star && p.make.is_promising(*p.star, p.best)) take(p, p.make.improved(*p.star));
}
void cdt_improved(PlanProgress& p) {
  if (p.make.is_promising(p.cdt, p.best)) take(p, p.make.improved(p.cdt));
}
void almonds_improved(PlanProgress& p) {
  const Candidate almond = p.make.from_almonds();
  if (almond.mesh->triangles.empty()) return;
  p.make.ranking().lower_ceiling(almond.merit.large);
  take(p, almond);
  if (p.make.is_promising(almond, p.best)) take(p, p.make.improved(almond));
}
void improved_again(PlanProgress& p) {
  const std::uint64_t most =
      p.best.merit.triangles * (has_couplings(p) ? effort::kLastCoupled : effort::kLastPerTriangle);
  take(p, p.make.improved_within(p.best, most));
  if (!p.best.merit.complete) take(p, p.make.improved_within(p.cdt, most));
}
void a_few_restarts(PlanProgress& p) {
  take(p, p.make.restarted_within(p.best, effort::kRestartsOfTiny));
}
void very_few_restarts(PlanProgress& p) {
  take(p, p.make.restarted_within(p.best, effort::kRestartsOfVeryWide));
}
/// The proof of promise 3 comes with the almonds.
void bound_kept(PlanProgress& p) {
  if (p.make.is_rest()) return;
  Candidate almond = p.make.from_almonds();
  if (almond.mesh->triangles.empty()) return;
  Candidate flipped = p.make.coupled(almond);
  take(p, flipped);
  take(p, std::move(almond));
  if (p.best.merit.negative > 0) p.best = narrowed_to_bound(p, flipped);
}
void bound_kept_sized(PlanProgress& p) {
  if (p.make.is_rest()) return;
  const Candidate almond = p.make.from_almonds();
  if (!almond.mesh->triangles.empty()) take(p, p.make.improved(almond));
}

// Steps that several plans have.
constexpr Step kPlain{"cdt", always, as_it_is, StopWhen::alone};
constexpr Step kStar{"one star", has_room_for_one_star, best_star, StopWhen::complete};
constexpr Step kLimits{"limits of that", may_be_near, limits, StopWhen::near};
constexpr Step kWithinBound{"the same within the bound", refined_is_beyond_bound, within_bound};
constexpr Step kFewerFar{"the same with fewer angles above 120 degrees", refined_has_far,
                         with_fewer_far};
constexpr Step kAlmonds{"almonds", is_beyond_bound, bound_kept};

constexpr std::array kFast{
    kPlain,       kStar,
    kLimits,      Step{"refined, improved", may_have_much_room, refined, StopWhen::complete},
    kWithinBound, kAlmonds,
};

// From the refined one on.
constexpr std::array kRefinedOnes{
    Step{"refined, improved, few searched", may_have_room, refined_and_searched,
         StopWhen::complete},
    kWithinBound,
    Step{"random restarts, a few", is_tiny_and_near, a_few_restarts, StopWhen::complete},
    Step{"random restarts, very few", is_tiny_and_very_wide, very_few_restarts, StopWhen::complete},
    Step{"best and cdt, improved", few_are_missed, improved_again, StopWhen::complete},
    Step{"refined, improved, searched", nearly_none_is_missed, refined_and_searched_again,
         StopWhen::complete},
    Step{"cdt, large angles searched", is_plain_and_above, searched_for_large, StopWhen::complete},
    kFewerFar,
    kAlmonds,
};

constexpr std::array kBalanced = joined(std::array{kPlain, kStar, kLimits}, kRefinedOnes);

/// All there is, by the balanced measure: what the default tries, whatever is proven of the star,
/// and then the rest.
constexpr std::array kThorough = joined(
    joined(std::array{kPlain, kStar}, kRefinedOnes),
    std::array{
        Step{"refined, improved, searched", always, refined_and_searched_all, StopWhen::complete},
        kWithinBound,
        kFewerFar,
        Step{"random restarts", is_tiny_and_missed, restarted, StopWhen::complete},
        Step{"best, improved", always, improved, StopWhen::complete},
        Step{"evenly refined, improved", always, evenly_refined, StopWhen::complete},
        Step{"one star, improved", always, star_improved, StopWhen::complete},
        Step{"cdt, improved", always, cdt_improved, StopWhen::complete},
        kAlmonds,
        Step{"almonds, improved", always, almonds_improved},
    });

// Steps after the restarts run only where the largest angle is neither the goal's nor forced.
constexpr std::array kLargest{
    kPlain,
    Step{"one star", has_room_for_one_star, one_star, StopWhen::complete},
    Step{"refined, improved, searched", always, largest_refined},
    Step{"random restarts", is_tiny_and_missed, restarted, StopWhen::done},
    Step{"best, improved", is_missed_by_largest, improved, StopWhen::done},
    Step{"evenly refined, improved", always, evenly_refined, StopWhen::done},
    Step{"one star, improved", always, star_improved, StopWhen::done},
    Step{"cdt, improved", always, cdt_improved, StopWhen::done},
    Step{"almonds, improved", always, almonds_improved},
};

// With wished sizes the refined one takes the place of the plain one, whatever it misses.
constexpr Step kSizedPlain{"cdt", always, as_it_is};
constexpr Step kSizedWithinBound{"the same within the bound at any price", would_give_sizes_up,
                                 within_bound_before_sizes};
constexpr Step kSizedAlmonds{"almonds, improved", is_beyond_bound, bound_kept_sized};

constexpr std::array kSizedFast{
    kSizedPlain,   Step{"refined, improved", always, sized}, kWithinBound, kSizedWithinBound,
    kSizedAlmonds,
};

constexpr std::array kSized{
    kSizedPlain,
    Step{"refined, improved, few searched", always, sized_and_searched, StopWhen::complete},
    kWithinBound,
    kSizedWithinBound,
    kFewerFar,
    kSizedAlmonds,
};

constexpr std::array kSizedThorough = joined(
    kSized,
    std::array{
        Step{"refined, improved, searched", always, refined_and_searched_all, StopWhen::complete},
        kWithinBound,
        kFewerFar,
        Step{"best, improved", always, improved},
        kSizedAlmonds,
    });

constexpr std::array kSizedLargest{
    kSizedPlain,
    Step{"refined, improved, searched", always, sized_and_searched_all},
    Step{"best, improved", is_missed_by_largest, improved},
    Step{"the same within the bound", would_give_sizes_up, within_bound},
    kSizedWithinBound,
    kSizedAlmonds,
};

}  // namespace

std::span<const Step> plan_for(const Options& options, bool has_sizes) {
  using Plan = std::span<const Step>;
  const bool is_thorough = options.effort == Effort::thorough;
  const bool is_largest = preferred(options) == Prefer::largest;
  if (options.effort == Effort::fast) return has_sizes ? Plan(kSizedFast) : Plan(kFast);
  if (has_sizes && is_largest) return kSizedLargest;
  if (has_sizes) return is_thorough ? Plan(kSizedThorough) : Plan(kSized);
  if (is_largest) return kLargest;
  return is_thorough ? Plan(kThorough) : Plan(kBalanced);
}

bool is_enough(const Step& step, const PlanProgress& p) {
  switch (step.stop) {
    case StopWhen::never:
      return false;
    case StopWhen::complete:
      return p.best.merit.complete;
    case StopWhen::alone:
      return p.best.merit.complete || p.make.outlook().has_no_room();
    case StopWhen::near:
      return p.best.merit.complete || p.is_settled;
    case StopWhen::done:
      return p.make.is_done(p.best);
  }
  return false;
}

Candidate run_plan(std::span<const Step> plan, Candidates& candidates) {
  PlanProgress progress{candidates};
  for (const Step& step : plan) {
    if (candidates.must_stop()) break;
    if (step.is_due(progress)) step.run(progress);
    if (is_enough(step, progress)) break;
  }
  return std::move(progress.best);
}

}  // namespace cover
