// Candidates, cheapest first, each only if those before it left something to be wished:
//   the constrained Delaunay triangulation as it is,
//   one star around a single new vertex,
//   the constrained Delaunay triangulation refined and improved (optimise),
//   in tiny regions, the best of random restarts,
//   what is best so far, improved for the region's own target,
//   Chew's construction where the boundary is evenly spaced, improved in the same way,
//   the star and the constrained Delaunay triangulation improved in the same way,
//   the almond method's result, improved: it carries the proof of promise 3.
// The last five where the largest angle is missed, and the last three only if they start with a
// smaller one or the region is small; none may use more than half of what is left of the budget,
// so that it reaches all. In the end, where few triangles miss the region's own target or are above
// 120 degrees, these alone are searched. What improvement makes worse is kept as it was, so the
// best of them is no worse than any. Tested by tests/unit/quality/quality_region_test.cpp.
#include "quality/quality_region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "cdt/cdt.hpp"
#include "covering/angle_limit.hpp"
#include "covering/cover_region.hpp"
#include "covering/local_frame.hpp"
#include "quality/chew.hpp"
#include "quality/hub.hpp"
#include "quality/missed_targets.hpp"
#include "quality/mutable_mesh.hpp"
#include "quality/optimise.hpp"
#include "quality/restart.hpp"
#include "quality/search.hpp"
#include "quality/size_field.hpp"
#include "quality/to_region_mesh.hpp"
#include "quality/with_neighbours.hpp"

namespace cover {
namespace {

constexpr std::uint64_t kEvaluationsPerVertex = 3000;
constexpr std::uint64_t kEvaluationsAtLeast = 5000;
constexpr std::uint64_t kEvaluationsOfRestarts = 200'000;  ///< far more than they need
constexpr std::uint64_t kEvaluationsOfSearch = 10'000;     ///< for what the best of them leaves
constexpr std::size_t kMostOfFew = 16;                     ///< triangles that are searched at last:
constexpr std::uint64_t kEvaluationsForOwn = 100'000;      ///< for the region's own target, each
constexpr std::uint64_t kEvaluationsForFar = 5'000;        ///< for 120 degrees
constexpr std::size_t kMostPoints = 2000;  ///< of a region that is tried with other goals
constexpr double kMany = 0.1;              ///< share of triangles above the goal that is many
constexpr std::size_t kSmallRegion = 64;   ///< points: every candidate is tried and improved

/// A triangulation of the region, in the frame, and what it has reached.
struct Candidate {
  MutableMesh mesh;
  Merit merit;
  std::string method;
};

LocalFrame frame_of(const RegionBoundary& boundary, bool shifted) {
  LocalFrame frame(boundary.points);
  if (!shifted) frame.undo(boundary.points);
  return frame;
}

/// One region in one frame.
class RegionWork {
 public:
  RegionWork(const RegionBoundary& boundary, const Options& options, std::stop_token stop,
             bool shifted)
      : boundary_(boundary),
        options_(options),
        goal_(Goal::of(options.max_angle, options.min_angle)),
        frame_(frame_of(boundary, shifted)),
        cdt_(triangulate_domain(frame_.points(), boundary.sides).triangulation),
        limit_(angle_limit(cdt_, boundary.sides, boundary.segments)),
        sizes_(boundary, cdt_, options.growth, background_in_frame()),
        given_(kEvaluationsAtLeast + kEvaluationsPerVertex * boundary.points.size()),
        budget_{given_, stop} {}

  /// ENSURES: no triangles if rounding on the way back to the plane turned one over, or the run is
  ///          to stop
  RegionMesh run() {
    Candidate best = best_candidate();
    try_other_goals(best);
    if (!sizes_.is_active() && boundary_.points.size() > kTinyRegion) search_what_is_left(best);
    if (budget_.stop.stop_requested()) return {};
    RegionMesh out = reported(best);
    best.mesh.set_goal(goal_);
    out.report.notes = missed_targets(best.mesh, boundary_, limit_, options_, is_budget_used_up(),
                                      frame_.origin());
    return out;
  }

  [[nodiscard]] bool is_shifted() const { return frame_.is_shifted(); }

 private:
  /// More budget may help: something was left undone, and little is left. In tiny regions a hundred
  /// times the budget helps no more than the restarts that they get.
  [[nodiscard]] bool is_budget_used_up() const {
    return boundary_.points.size() > kTinyRegion && budget_.was_too_small &&
           budget_.left < given_ / 8;
  }

  Candidate best_candidate() {
    Candidate best = as_it_is();
    if (sizes_.is_active()) return sized(std::move(best));
    if (best.merit.complete) return best;
    ceiling_ = best.merit.large;
    Candidate cdt = best;
    std::optional<Candidate> hub;
    const bool hub_may_do = has_room_around_a_hub();
    if (hub_may_do) hub = one_star(cdt);
    if (hub && hub->merit.complete) return *std::move(hub);
    take_if_better(best, optimised(cdt));
    const bool is_tiny = boundary_.points.size() <= kTinyRegion;
    if (is_tiny && !best.merit.complete) take_if_better(best, restarted(best));
    if (is_done(best)) return best;
    take_if_better(best, improved(best));
    if (is_done(best)) return best;
    if (std::optional<Candidate> even = evenly_refined(cdt)) take_if_better(best, improved(*even));
    if (is_done(best)) return best;
    if (!hub_may_do) hub = one_star(cdt);
    if (hub && is_promising(*hub, best)) take_if_better(best, improved(*hub));
    if (is_done(best)) return best;
    if (is_promising(cdt, best)) take_if_better(best, improved(cdt));
    if (is_done(best)) return best;
    Candidate almond = from_almonds();
    if (almond.mesh.triangles.empty()) return best;
    ceiling_ = std::min(ceiling_, almond.merit.large);
    take_if_better(best, almond);
    if (is_promising(almond, best)) take_if_better(best, improved(almond));
    return best;
  }

  /// Whether the angles at a vertex that sees all sides can be as large as the goal asks.
  [[nodiscard]] bool has_room_around_a_hub() const {
    const double least = std::atan2(1.0, goal_.small);
    return goal_.weight == 0 ||
           static_cast<double>(boundary_.sides.size()) * least < 2 * std::numbers::pi;
  }

  /// With wished sizes there is one candidate, unless it misses what the almond method proves.
  Candidate sized(Candidate cdt) {
    Candidate best = optimised(std::move(cdt));
    if (!is_done(best)) take_if_better(best, improved(best));
    if (best.merit.large <= 1 / std::tan(limit_.promised_nu())) return best;
    take_if_better(best, improved(from_almonds()));
    return best;
  }

  /// Whether improving `start` may lead to something better than `best`: it is better already, or
  /// the region is so small that it can be tried in any case.
  [[nodiscard]] bool is_promising(const Candidate& start, const Candidate& best) const {
    return !start.mesh.triangles.empty() &&
           (start.merit.large < best.merit.large || boundary_.points.size() <= kSmallRegion);
  }

  /// The largest angle is that of the goal, or forced by the region's worst side; or the run is to
  /// stop.
  [[nodiscard]] bool is_done(const Candidate& candidate) const {
    return budget_.stop.stop_requested() ||
           !is_smaller_cot(target(candidate.mesh), candidate.merit.large);
  }

  /// -cot of the region's own target: the largest angle of the goal, or what its worst side forces.
  [[nodiscard]] double target(const MutableMesh& mesh) const {
    double target = goal_.large;
    for (const SideLimit& side : mesh.sides) target = std::max(target, -side.apex_cot);
    return target;
  }

  /// The goal with the region's own target: all is done then for the triangles that miss that.
  [[nodiscard]] Goal own_goal(const MutableMesh& mesh) const {
    return {target(mesh), goal_.small, goal_.weight};
  }

  /// ENSURES: a largest angle above the ceiling is taken only instead of another one
  void take_if_better(Candidate& best, Candidate other) const {
    const bool fits = !is_smaller_cot(ceiling_, other.merit.large);
    const bool best_fits = !is_smaller_cot(ceiling_, best.merit.large);
    if (fits == best_fits ? is_better(other.merit, best.merit) : fits) best = std::move(other);
  }

  [[nodiscard]] SizeFunction background_in_frame() const {
    if (!options_.size_field) return {};
    return [&field = options_.size_field, frame = &frame_](Point p) {
      return field(frame->restore(p));
    };
  }

  [[nodiscard]] Candidate as_it_is() const { return candidate(cdt_, "cdt"); }

  [[nodiscard]] Candidate candidate(const Triangulation& triangles, std::string method) const {
    Candidate c{MutableMesh(triangles, fixed(), locate_sides(triangles, boundary_.sides),
                            side_limits(cdt_, limit_.at)),
                {},
                std::move(method)};
    c.mesh.set_goal(goal_);
    c.merit = merit_of(c.mesh, goal_);
    return c;
  }

  [[nodiscard]] std::optional<Candidate> one_star(const Candidate& cdt) {
    std::uint64_t evaluations = 0;
    const auto star = hub_triangulation(cdt.mesh, boundary_, evaluations);
    budget_.spend(evaluations);
    if (!star) return std::nullopt;
    return candidate(*star, "one star");
  }

  [[nodiscard]] std::optional<Candidate> evenly_refined(Candidate cdt) const {
    if (!refine_evenly(cdt.mesh)) return std::nullopt;
    cdt.merit = merit_of(cdt.mesh, goal_);
    cdt.method = "evenly refined";
    return cdt;
  }

  [[nodiscard]] Candidate optimised(Candidate c) {
    Budget half = budget_.share(2);  // the rest is for candidates that may start better
    c.merit = optimise(c.mesh, goal_, half, sizes_);
    budget_.take_back(half);
    c.method = "refined, improved";
    return c;
  }

  /// Other goals may lead nearer to the one that was missed. 90 and 30 degrees can be met where
  /// more cannot; and where many angles are large, they are so beside small ones that are forced.
  void try_other_goals(Candidate& best) {
    const std::size_t points = boundary_.points.size();
    if (sizes_.is_active() || best.merit.complete || points <= kTinyRegion || points > kMostPoints)
      return;
    const Angle right = Angle::degrees(90), third = Angle::degrees(30);
    if (options_.max_angle < right || third < options_.min_angle) {
      try_goal(best,
               Goal::of(std::max(options_.max_angle, right), std::min(options_.min_angle, third)));
    }
    for (const double part : {0.25, 0.0}) {
      if (static_cast<double>(best.merit.above) <=
          kMany * static_cast<double>(best.merit.triangles))
        return;
      const Angle min = Angle::radians(part * options_.min_angle.in_radians());
      try_goal(best, Goal::of(options_.max_angle, min));
    }
  }

  void try_goal(Candidate& best, const Goal& goal) {
    const Goal asked = std::exchange(goal_, goal);
    const Budget left = std::exchange(budget_, Budget{given_ / 2, budget_.stop});
    const double ceiling = ceiling_;
    Candidate other = best_candidate();
    goal_ = asked;
    budget_ = left;
    ceiling_ = ceiling;
    other.mesh.set_goal(goal_);
    other.merit = merit_of(other.mesh, goal_);
    take_if_better(best, std::move(other));
  }

  /// ENSURES: no worse than `c`. Improvement looks at excesses, where a very small angle may weigh
  ///          as much as a large one.
  [[nodiscard]] Candidate improved(const Candidate& c) {
    Candidate better = c;
    // For the region's own target first.
    const Goal own = own_goal(c.mesh);
    Budget half = budget_.share(2);
    if (own.large > goal_.large) {
      improve_largest(better.mesh, own, half);
      better.merit = merit_of(better.mesh, goal_);
    }
    // What sides force beyond the goal is allowed beside them, so the largest angle may grow.
    Candidate further = better;
    further.merit = improve_largest(further.mesh, goal_, half);
    take_if_better(better, std::move(further));
    budget_.take_back(half);
    if (!is_better(better.merit, c.merit)) return c;
    if (!better.method.ends_with(", improved")) better.method += ", improved";
    return better;
  }

  /// The best of random restarts; where that misses the target for the largest angle, what a
  /// search makes of it.
  [[nodiscard]] Candidate restarted(const Candidate& from) const {
    Candidate best = from;
    Budget budget{kEvaluationsOfRestarts, budget_.stop};
    best.mesh = best_restart(from.mesh, goal_, ceiling_, best.merit, budget);
    if (is_better(best.merit, from.merit)) best.method = "restarted, improved";
    if (is_done(best) && best.merit.above == 0) return best;
    Candidate further = best;
    budget = {kEvaluationsOfSearch, budget_.stop};
    search_excerpts(further.mesh, goal_, budget);
    further.merit = merit_of(further.mesh, goal_);
    take_if_better(best, std::move(further));
    return best;
  }

  /// Searches for the few triangles that miss the region's own target or are above 120 degrees,
  /// where that is not the goal.
  void search_what_is_left(Candidate& best) const {
    const Goal own = own_goal(best.mesh);
    if (!is_done(best) && own != goal_) search_few(best, own, kEvaluationsForOwn);
    const Goal far{std::max(goal_.large, kFarAbove), goal_.small, goal_.weight};
    if (best.merit.far_above > 0 && far != goal_) search_few(best, far, kEvaluationsForFar);
  }

  /// Spends `each` evaluations per triangle at most.
  void search_few(Candidate& best, const Goal& aim, std::uint64_t each) const {
    const std::size_t above = merit_of(best.mesh, aim).above;
    if (above > kMostOfFew) return;
    Candidate further = best;
    Budget budget{above * each, budget_.stop};
    search_excerpts(further.mesh, aim, budget, Effort::most);
    further.mesh.set_goal(goal_);
    further.merit = merit_of(further.mesh, goal_);
    take_if_better(best, std::move(further));
  }

  /// The almond method's triangulation: it carries the proof of promise 3.
  [[nodiscard]] Candidate from_almonds() const {
    const RegionMesh almond = cover_region(boundary_, options_, budget_.stop);
    std::vector<Point> points = frame_.points();
    for (const Point& p : almond.steiner) points.push_back(frame_.enter(p));
    return candidate(with_neighbours(std::move(points), almond.triangles), "almond");
  }

  [[nodiscard]] RegionMesh reported(const Candidate& candidate) const {
    RegionMesh out = to_region_mesh(candidate.mesh, frame_, boundary_.points);
    RegionReport& report = out.report;
    report.id = boundary_.id;
    report.method = candidate.method;
    report.nu_opt = Angle::radians(limit_.nu);
    report.nu_bound = Angle::radians(limit_.promised_nu());
    report.forced_above_120 = limit_.above_120;
    report.forced_above_150 = limit_.above_150;
    return out;
  }

  [[nodiscard]] std::uint32_t fixed() const {
    return static_cast<std::uint32_t>(boundary_.points.size());
  }

  const RegionBoundary& boundary_;
  const Options& options_;
  Goal goal_;
  LocalFrame frame_;
  Triangulation cdt_;
  AngleLimit limit_;
  SizeField sizes_;
  const std::uint64_t given_;  ///< the whole budget
  Budget budget_;
  double ceiling_ = kInverted;  ///< -cot of the largest angle of the plain methods
};

}  // namespace

RegionMesh quality_region(const RegionBoundary& boundary, const Options& options,
                          std::stop_token stop) {
  RegionWork shifted(boundary, options, stop, true);
  RegionMesh mesh = shifted.run();
  if (mesh.triangles.empty() && shifted.is_shifted() && !stop.stop_requested()) {
    mesh = RegionWork(boundary, options, stop, false).run();
  }
  return mesh;
}

}  // namespace cover
