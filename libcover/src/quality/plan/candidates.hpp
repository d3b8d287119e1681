// Triangulations of one region in a frame of its own: made, improved, and compared.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>

#include <cover/options.hpp>

#include "cdt/triangulation.hpp"
#include "limits/region_proof.hpp"
#include "quality/effort/effort.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "quality/plan/candidate.hpp"
#include "quality/plan/optimise.hpp"
#include "quality/plan/outlook.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"
#include "sizes/size_field.hpp"
#include "target/angle_limit.hpp"
#include "target/goal.hpp"
#include "target/local_frame.hpp"

namespace cover {

/// What can be tried on a region. What refines or improves shares one budget and takes at most half
/// of what is left, so that it reaches all. Random restarts and searches of single triangles have
/// budgets of their own.
class Candidates {
 public:
  /// `almonds` is what almond_region() made of the region, where it was asked already.
  ///
  /// REQUIRES: `boundary` and `options` outlive this object
  Candidates(const RegionBoundary& boundary, const Options& options, const std::stop_token& stop,
             bool shifted, const Sharing& sharing = {}, std::optional<RegionMesh> almonds = {});
  Candidates(const Candidates&) = delete;
  Candidates& operator=(const Candidates&) = delete;

  [[nodiscard]] const LocalFrame& frame() const { return frame_; }
  /// The threads that may work on this region.
  [[nodiscard]] const Team& team() const { return sharing_.team; }
  [[nodiscard]] const AngleLimit& limit() const { return limit_; }
  [[nodiscard]] bool is_rest() const { return boundary_.is_rest; }
  [[nodiscard]] bool has_sizes() const { return sizes_.is_active(); }
  /// Whether no edge inside is more than twice as long as asked, as in refined meshes; false where
  /// points have sizes of their own, or edges are to grow.
  [[nodiscard]] bool keeps_sizes(const Candidate& candidate) const;
  /// Random restarts then find what there is.
  [[nodiscard]] bool is_tiny() const { return boundary_.points.size() <= kTinyRegion; }
  [[nodiscard]] bool must_stop() const { return budget_.stop.stop_requested(); }
  /// More budget may help: something was left undone, and little is left. In tiny regions a hundred
  /// times the budget helps no more than the restarts that they get.
  [[nodiscard]] bool is_budget_used_up() const;

  /// What is taken of two.
  [[nodiscard]] Ranking& ranking() { return ranking_; }
  [[nodiscard]] const Ranking& ranking() const { return ranking_; }
  /// What more there is to be had.
  [[nodiscard]] Outlook& outlook() { return outlook_; }
  [[nodiscard]] const Outlook& outlook() const { return outlook_; }

  [[nodiscard]] const Goal& goal() const { return goal_; }
  /// The goal with other angles.
  [[nodiscard]] Goal goal_for(Angle max, Angle min) const {
    Goal goal = Goal::of(max, min);
    goal.coupling = goal_.coupling;
    return goal;
  }
  /// The goal with couplings that keep angles farther below the bound: they would end just above.
  [[nodiscard]] Goal goal_below_bound() const {
    Goal goal = goal_;
    goal.coupling.bound -= effort::kCouplingsBelowBound;
    return goal;
  }
  /// The goal with the region's own target: the largest angle of the goal, or what its worst side
  /// forces.
  [[nodiscard]] Goal own_goal(const MutableMesh& mesh) const;

  /// The constrained Delaunay triangulation.
  [[nodiscard]] Candidate as_it_is() const;
  /// One star around a single new vertex, if there is one that sees all sides.
  [[nodiscard]] std::optional<Candidate> one_star(const Candidate& cdt);
  /// Whether so few sides share the 360 degrees at it that each may have the smallest angle asked.
  [[nodiscard]] bool has_room_for_one_star() const;
  /// Chew's construction, where the boundary is evenly spaced.
  [[nodiscard]] std::optional<Candidate> evenly_refined(Candidate cdt) const;
  /// The constrained Delaunay triangulation refined and improved; nothing promises that it is
  /// better.
  [[nodiscard]] Candidate optimised(Candidate cdt, SearchAfter how_hard);
  /// The same with a budget of its own.
  [[nodiscard]] Candidate optimised_within(Candidate cdt, SearchAfter how_hard,
                                           std::uint64_t evaluations);
  /// Improved for the region's own target first, then for the goal.
  ///
  /// ENSURES: no worse than `c`. Improvement looks at excesses, where a very small angle may weigh
  ///          as much as a large one.
  [[nodiscard]] Candidate improved(const Candidate& c);
  /// The same with a budget of its own.
  [[nodiscard]] Candidate improved_within(const Candidate& c, std::uint64_t evaluations);
  /// Without the vertices inside that make couplings of sides negative.
  [[nodiscard]] Candidate giving_way(Candidate c) const;
  /// What becomes of `from` when its angles above -cot `large` are narrowed at the price of small
  /// angles, as little of them as leads there, of `parts` of the goal's; or `best` if that is
  /// better. Takes `each` star evaluations for a triangle at most.
  [[nodiscard]] Candidate narrowed(const Candidate& best, const Candidate& from, double large,
                                   std::uint64_t each,
                                   std::span<const double> parts = effort::kSmallestParts);
  /// The best of random restarts.
  [[nodiscard]] Candidate restarted_within(const Candidate& from, std::uint64_t evaluations) const;
  /// The best of random restarts; where that misses the target for the largest angle, what a
  /// search makes of it.
  [[nodiscard]] Candidate restarted(const Candidate& from) const;
  /// What a search makes of the triangles that miss `aim`, if they are few, with `each` evaluations
  /// for each at most, besides the budget.
  [[nodiscard]] Candidate searched(const Candidate& from, const Goal& aim,
                                   std::uint64_t each) const;
  /// The almond method's triangulation: it carries the proof of promise 3. Empty if the run is to
  /// stop.
  [[nodiscard]] Candidate from_almonds();
  /// With its inner edges flipped until none has a negative coupling, if these count.
  [[nodiscard]] Candidate coupled(Candidate c) const;
  /// What `find` makes when it aims at another goal, with half the budget of a region.
  template <class Find>
  [[nodiscard]] Candidate with_goal(const Goal& goal, Find find) {
    const Goal asked = std::exchange(goal_, goal);
    const Budget budget = std::exchange(budget_, Budget{given_ / 2, budget_.stop});
    const Ranking ranking = ranking_;
    ranking_.lift_ceiling();
    Candidate found = find();
    goal_ = asked;
    budget_ = budget;
    ranking_ = ranking;
    return measured(std::move(found));
  }

  /// The largest angle is that of the goal, or forced by the region's worst side; or the run is to
  /// stop.
  [[nodiscard]] bool is_done(const Candidate& candidate) const;
  /// Asks outlook() whether `cdt` is the only mesh without a negative coupling that counts, if it
  /// is such a mesh, within the bound.
  void look_for_room(const Candidate& cdt);
  /// From now on candidates are compared as for a region with this constrained Delaunay
  /// triangulation; by Prefer::largest none with a larger angle is taken instead of it.
  void compare_with(const Candidate& cdt);
  /// What the almond method made of the region in the plane, if it was asked, handed over: nothing
  /// else is asked of these candidates from then on.
  [[nodiscard]] std::optional<RegionMesh> take_almonds() { return std::move(almonds_); }
  /// Whether improving `start` may lead to something better than `best`: it is better already, or
  /// the region is so small that it can be tried in any case.
  [[nodiscard]] bool is_promising(const Candidate& start, const Candidate& best) const;

 private:
  [[nodiscard]] SizeFunction background_in_frame() const;
  /// Side s is the edge side_at[s] of `triangles`.
  [[nodiscard]] Candidate plain(const Triangulation& triangles, std::span<const EdgeRef> side_at,
                                std::string method) const;
  /// With its merit by the present goal.
  [[nodiscard]] Candidate measured(Candidate c) const;

  const RegionBoundary& boundary_;
  std::optional<RegionMesh> almonds_;  ///< what almond_region() made, once asked
  const Options& options_;
  Sharing sharing_;
  LocalFrame frame_;
  Outlook outlook_;
  const Triangulation& cdt_;
  AngleLimit limit_;
  SideLimits side_limits_;
  Goal goal_;
  SizeField sizes_;
  std::uint64_t given_;  ///< the whole budget
  Budget budget_;
  Ranking ranking_;
};

}  // namespace cover
