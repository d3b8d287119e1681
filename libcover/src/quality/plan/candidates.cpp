// See candidates.hpp. Tested by tests/unit/quality/plan/candidates_test.cpp.
#include "quality/plan/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "almond/almond_region.hpp"
#include "cdt/region_cdt.hpp"
#include "cdt/sides.hpp"
#include "cdt/triangulation.hpp"
#include "geom/cotangent.hpp"
#include "geom/vector.hpp"
#include "options/intent.hpp"
#include "quality/effort/effort.hpp"
#include "quality/fault/extreme_angles.hpp"
#include "quality/mutable/delaunay_flips.hpp"
#include "quality/mutable/split_hull.hpp"
#include "quality/repair/best_restart.hpp"
#include "quality/repair/give_way.hpp"
#include "quality/repair/improve.hpp"
#include "quality/repair/search.hpp"
#include "quality/starts/even_refinement.hpp"
#include "quality/starts/one_star.hpp"
#include "region/whole_mesh.hpp"
#include "sizes/fields/ask_size.hpp"

namespace cover {
namespace {

constexpr double kTwice = 2;  ///< as long as asked are the longest edges of refined meshes

LocalFrame frame_of(const RegionBoundary& boundary, bool shifted) {
  LocalFrame frame(boundary.points);
  if (!shifted) frame.undo(boundary.points);
  return frame;
}

/// With little effort by what is known of any region, which saves a tenth of the time.
Triangulation triangulated(const std::vector<Point>& points, const RegionBoundary& boundary,
                           Effort effort, const Team& team) {
  const auto make = effort == Effort::fast ? triangulate_in_order : triangulate_region;
  return make(points, boundary.sides, boundary.known_triangles(), team);
}

/// With couplings first: those of sides count that no vertex of the boundary encroaches.
std::vector<SideLimit> counted_side_limits(const Triangulation& cdt, const AngleLimit& limit,
                                           const Options& options, const Team& team) {
  std::vector<SideLimit> limits = side_limits(cdt, limit.at, team);
  if (couplings_count(options)) mind_free_sides(cdt, limit.at, limits, team);
  return limits;
}

Goal goal_of(const Options& options, const AngleLimit& limit, bool is_rest) {
  Goal goal = Goal::of(options.max_angle, options.min_angle);
  if (couplings_count(options))
    // Beside layers, of 400 devices with little effort two kept negative couplings inside with it.
    goal.coupling = {.weight = kCouplingFirst,
                     .inside = true,
                     .strict = true,
                     .bound = (1 - kSameCot) / std::tan(limit.promised_nu()),
                     .takes_whole_cavities = !is_rest};
  return goal;
}

}  // namespace

Candidates::Candidates(const RegionBoundary& boundary, const Options& options,
                       const std::stop_token& stop, bool shifted, const Sharing& sharing,
                       std::optional<RegionMesh> almonds)
    : boundary_(boundary),
      almonds_(std::move(almonds)),
      options_(options),
      sharing_{sharing.team, sharing.part_size, stop},
      frame_(frame_of(boundary, shifted)),
      outlook_(boundary, options,
               triangulated(frame_.take_points(), boundary, options.effort, sharing.team),
               sharing.team),
      cdt_(outlook_.cdt()),
      limit_(angle_limit(cdt_, boundary.sides, boundary.segments, sharing.team)),
      side_limits_(counted_side_limits(cdt_, limit_, options, sharing.team)),
      goal_(goal_of(options, limit_, boundary.is_rest)),
      sizes_(SizeField::where_it_counts(boundary, cdt_, options.growth, background_in_frame())),
      given_(effort::kBudgetAtLeast + effort::kBudgetPerPoint * boundary.points.size()),
      budget_{given_, stop} {}

SizeFunction Candidates::background_in_frame() const {
  SizeFunction field = background_of(boundary_, options_);
  if (!field) return {};
  return [field = std::move(field), frame = &frame_](Point p) {
    return ask_size(field, frame->restore(p));
  };
}

bool Candidates::keeps_sizes(const Candidate& candidate) const {
  if (options_.growth || !boundary_.size_at.empty()) return false;
  const MutableMesh& mesh = *candidate.mesh;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    for (const Corner i : kCorners) {
      const std::uint32_t n = mesh.triangles[t].n[i];
      if (is_side(n) || n < t) continue;
      const Point a = mesh.corner(t, i.next()), b = mesh.corner(t, i.previous());
      for (const Point p : {a, midpoint(a, b), b})
        if (length(b - a) > kTwice * sizes_.largest_at(p)) return false;
    }
  }
  return true;
}

bool Candidates::is_budget_used_up() const {
  return !is_tiny() && budget_.was_too_small && budget_.left < given_ / 8;
}

Goal Candidates::own_goal(const MutableMesh& mesh) const {
  Goal own = goal_;
  for (const SideLimit& side : mesh.sides) own.large = std::max(own.large, -side.apex_cot);
  return own;
}

Candidate Candidates::as_it_is() const { return measured(plain(cdt_, limit_.at, "cdt")); }

Candidate Candidates::plain(const Triangulation& triangles, std::span<const EdgeRef> side_at,
                            std::string method) const {
  const auto fixed = static_cast<std::uint32_t>(boundary_.points.size());
  return {
      MutableMesh(triangles, fixed, side_at, side_limits_, sharing_.team), {}, std::move(method)};
}

Candidate Candidates::coupled(Candidate c) const {
  if (goal_.coupling.inside) make_delaunay(c.mesh.change(), sharing_.team);
  return measured(std::move(c));
}

Candidate Candidates::measured(Candidate c) const {
  if (c.mesh->goal() != goal_) c.mesh.change().set_goal(goal_, sharing_.team);
  c.merit = merit_of(*c.mesh, goal_, sharing_.team);
  return c;
}

bool Candidates::has_room_for_one_star() const {
  const double least = angle_of_cot(goal_.small);
  return goal_.weight == 0 ||
         static_cast<double>(boundary_.sides.size()) * least < 2 * std::numbers::pi;
}

std::optional<Candidate> Candidates::one_star(const Candidate& cdt) {
  const OneStar found = cover::one_star(*cdt.mesh, boundary_);
  budget_.spend(found.evaluations);
  if (!found.star) return std::nullopt;
  const std::vector<EdgeRef> side_at = locate_sides(*found.star, boundary_.sides, sharing_.team);
  Candidate made = coupled(plain(*found.star, side_at, "one star"));
  outlook_.has_seen(extreme_angles(*made.mesh));
  return made;
}

std::optional<Candidate> Candidates::evenly_refined(Candidate cdt) const {
  if (!refine_evenly(cdt.mesh.change())) return std::nullopt;
  cdt.method = "evenly refined";
  return measured(std::move(cdt));
}

Candidate Candidates::optimised(Candidate cdt, SearchAfter how_hard) {
  Budget half = budget_.share(2);  // the rest is for candidates that may start better
  const Optimised reached =
      optimise(cdt.mesh.change(), goal_, half, {&sizes_, ranking_.order(), how_hard, sharing_});
  cdt.merit = reached.merit;
  if (reached.before_couplings) outlook_.has_seen(*reached.before_couplings);
  budget_.take_back(half);
  cdt.method = "refined, improved";
  return cdt;
}

Candidate Candidates::improved(const Candidate& c) {
  Candidate better = c;
  const Goal own = own_goal(*c.mesh);
  Budget half = budget_.share(2);
  if (own != goal_) {
    improve_largest(better.mesh.change(), own, half, sharing_);
    better.merit = merit_of(*better.mesh, goal_, sharing_.team);
  }
  // What sides force beyond the goal is allowed beside them, so the largest angle may grow.
  Candidate further = better;
  further.merit = improve_largest(further.mesh.change(), goal_, half, sharing_);
  ranking_.take_if_better(better, std::move(further));
  budget_.take_back(half);
  if (!ranking_.order().is_better(better.merit, c.merit)) return c;
  if (!better.method.ends_with(", improved")) better.method += ", improved";
  return better;
}

Candidate Candidates::giving_way(Candidate c) const {
  return give_way_to_sides(c.mesh.change()) > 0 ? measured(std::move(c)) : c;
}

Candidate Candidates::narrowed(const Candidate& best, const Candidate& from, double large,
                               std::uint64_t each, std::span<const double> parts) {
  Candidate found = best;
  const double smallest = angle_of_cot(goal_.small);
  Candidate trial = from;
  bool is_better = false;
  budget_.within(each * from.merit.triangles, [&] {
    for (const double part : parts) {
      if (budget_.is_used_up()) break;
      Goal aim = goal_.with(std::max(goal_.large, large - effort::kAimBelowLimit), goal_.small,
                            goal_.weight);
      if (goal_.weight > 0) {
        aim.small = cot_of(part * smallest);
        aim.weight = part * smallest / (std::numbers::pi - angle_of_cot(-aim.large));
      }
      MutableMesh& mesh = trial.mesh.change();
      mesh.set_goal(aim, sharing_.team);
      budget_.spend(improve(mesh, budget_.left, {}, sharing_).evaluations);
      trial = measured(std::move(trial));
      if (ranking_.order().is_better(trial.merit, found.merit)) {
        found = trial;
        is_better = true;
      }
      if (trial.merit.large <= large || (large == kFarAbove && trial.merit.far_above == 0)) break;
    }
  });
  if (is_better && !found.method.ends_with(", improved")) found.method += ", improved";
  return found;
}

void Candidates::compare_with(const Candidate& cdt) {
  const Order order{.prefer = preferred(options_), .bound = cot_of(limit_.promised_nu())};
  ranking_.set_order(order);
  if (order.prefer == Prefer::largest) ranking_.lower_ceiling(cdt.merit.large);
}

bool Candidates::is_promising(const Candidate& start, const Candidate& best) const {
  return !start.mesh->triangles.empty() && (start.merit.large < best.merit.large ||
                                            boundary_.points.size() <= effort::kPointsToTryAll);
}

Candidate Candidates::improved_within(const Candidate& c, std::uint64_t evaluations) {
  Candidate better;
  budget_.within(evaluations, [&] { better = improved(c); });
  return better;
}

Candidate Candidates::optimised_within(Candidate cdt, SearchAfter how_hard,
                                       std::uint64_t evaluations) {
  Candidate better;  // of the budget no more than half is for one
  budget_.within(2 * evaluations, [&] { better = optimised(std::move(cdt), how_hard); });
  return better;
}

Candidate Candidates::restarted_within(const Candidate& from, std::uint64_t evaluations) const {
  Budget budget{evaluations, budget_.stop};
  Restarted best = best_restart(*from.mesh, from.merit, goal_, ranking_.ceiling(), budget);
  return measured({std::move(best.mesh), best.merit, "restarted, improved"});
}

Candidate Candidates::restarted(const Candidate& from) const {
  Budget budget{effort::kRestartsOfAllEffort, budget_.stop};
  Restarted found = best_restart(*from.mesh, from.merit, goal_, ranking_.ceiling(), budget);
  Candidate best{std::move(found.mesh), found.merit, from.method};
  if (ranking_.order().is_better(best.merit, from.merit)) best.method = "restarted, improved";
  if (is_done(best) && best.merit.above == 0) return best;
  Candidate further = best;
  budget = {effort::kSearchAfterRestarts, budget_.stop};
  search_excerpts(further.mesh.change(), goal_, budget);
  ranking_.take_if_better(best, measured(std::move(further)));
  return best;
}

Candidate Candidates::searched(const Candidate& from, const Goal& aim, std::uint64_t each) const {
  const std::size_t above = merit_of(*from.mesh, aim, sharing_.team).above;
  if (above > effort::kSearchedAlone) return from;
  Candidate further = from;
  Budget budget{above * each, budget_.stop};
  search_excerpts(further.mesh.change(), aim, budget, Restarts::at_last);
  return measured(std::move(further));
}

Candidate Candidates::from_almonds() {
  if (!almonds_) almonds_ = almond_region(boundary_, options_, budget_.stop);
  const RegionMesh& almond = *almonds_;
  if (find_flaw({all_points(boundary_, almond), almond.triangles, boundary_.sides,
                 boundary_.segments, boundary_.points.size()}))
    return {};  // stopped, or broken by rounding
  std::vector<Point> points = cdt_.points;
  for (const Point& p : almond.steiner) points.push_back(frame_.enter(p));
  Triangulation triangles = with_neighbours(std::move(points), almond.triangles);
  const SplitSides sides = locate_split_sides(triangles, boundary_);
  std::vector<SideLimit> limits(side_limits_.begin(), side_limits_.end());
  for (const std::uint32_t s : sides.split) limits[s] = kNoLimit;
  limits.resize(sides.at.size(), kNoLimit);
  return measured({MutableMesh(triangles, sides.fixed, sides.at, std::move(limits)), {}, "almond"});
}

bool Candidates::is_done(const Candidate& candidate) const {
  if (candidate.merit.negative > 0) return must_stop();
  return must_stop() || !is_smaller_cot(own_goal(*candidate.mesh).large, candidate.merit.large);
}

void Candidates::look_for_room(const Candidate& cdt) {
  outlook_.forget_room();
  if (goal_.coupling.inside && cdt.merit.negative == 0 && ranking_.is_within_bound(cdt))
    outlook_.look_for_room(side_limits_);
}

}  // namespace cover
