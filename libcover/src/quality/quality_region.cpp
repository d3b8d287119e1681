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
// smaller one or the region is small. Where the goal is missed still, the same again with other
// goals; and where few triangles miss the region's own target or are above 120 degrees, a search
// for these alone. What improvement makes worse is kept as it was, so the best of them is no worse
// than any. Tested by tests/unit/quality/quality_region_test.cpp.
#include "quality/quality_region.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "quality/fault/missed_targets.hpp"
#include "quality/mutable/to_region_mesh.hpp"
#include "quality/plan/candidates.hpp"

namespace cover {
namespace {

constexpr std::size_t kSmallRegion = 64;   ///< points: every candidate is tried and improved
constexpr std::size_t kMostPoints = 2000;  ///< of a region that is tried with other goals
constexpr double kMany = 0.1;              ///< share of triangles above the goal that is many
constexpr std::uint64_t kEvaluationsForOwn = 100'000;  ///< per triangle above the own target
constexpr std::uint64_t kEvaluationsForFar = 5'000;    ///< per triangle above 120 degrees

/// One region in one frame.
class RegionWork {
 public:
  RegionWork(const RegionBoundary& boundary, const Options& options, std::stop_token stop,
             bool shifted)
      : boundary_(boundary), options_(options), candidates_(boundary, options, stop, shifted) {}

  /// ENSURES: no triangles if rounding on the way back to the plane turned one over, or the run is
  ///          to stop
  RegionMesh run() {
    Candidate best = candidates_.has_sizes() ? best_sized() : best_candidate();
    if (!candidates_.has_sizes() && !candidates_.is_tiny()) {
      aim_elsewhere(best);
      search_what_is_left(best);
    }
    if (candidates_.must_stop()) return {};
    RegionMesh out = reported(best);
    best.mesh.set_goal(candidates_.goal());
    out.report.notes =
        missed_targets(best.mesh, boundary_, candidates_.limit(), options_,
                       candidates_.is_budget_used_up(), candidates_.frame().origin());
    return out;
  }

  [[nodiscard]] bool is_shifted() const { return candidates_.frame().is_shifted(); }

 private:
  Candidate best_candidate() {
    Candidate best = candidates_.as_it_is();
    if (best.merit.complete) return best;
    candidates_.lower_ceiling(best.merit.large);
    const Candidate cdt = best;
    std::optional<Candidate> hub;
    const bool hub_may_do = candidates_.has_room_around_a_hub();
    if (hub_may_do) hub = candidates_.one_star(cdt);
    if (hub && hub->merit.complete) return *std::move(hub);
    candidates_.take_if_better(best, candidates_.optimised(cdt));
    if (candidates_.is_tiny() && !best.merit.complete)
      candidates_.take_if_better(best, candidates_.restarted(best));
    if (candidates_.is_done(best)) return best;
    candidates_.take_if_better(best, candidates_.improved(best));
    if (candidates_.is_done(best)) return best;
    const std::optional<Candidate> even = candidates_.evenly_refined(cdt);
    if (even) candidates_.take_if_better(best, candidates_.improved(*even));
    if (candidates_.is_done(best)) return best;
    if (!hub_may_do) hub = candidates_.one_star(cdt);
    if (hub && is_promising(*hub, best))
      candidates_.take_if_better(best, candidates_.improved(*hub));
    if (candidates_.is_done(best)) return best;
    if (is_promising(cdt, best)) candidates_.take_if_better(best, candidates_.improved(cdt));
    if (candidates_.is_done(best)) return best;
    const Candidate almond = candidates_.from_almonds();
    if (almond.mesh.triangles.empty()) return best;
    candidates_.lower_ceiling(almond.merit.large);
    candidates_.take_if_better(best, almond);
    if (is_promising(almond, best)) candidates_.take_if_better(best, candidates_.improved(almond));
    return best;
  }

  /// With wished sizes there is one candidate, unless it misses what the almond method proves.
  Candidate best_sized() {
    Candidate best = candidates_.optimised(candidates_.as_it_is());
    if (!candidates_.is_done(best)) candidates_.take_if_better(best, candidates_.improved(best));
    if (best.merit.large <= 1 / std::tan(candidates_.limit().promised_nu())) return best;
    const Candidate almond = candidates_.from_almonds();
    if (!almond.mesh.triangles.empty())
      candidates_.take_if_better(best, candidates_.improved(almond));
    return best;
  }

  /// Whether improving `start` may lead to something better than `best`: it is better already, or
  /// the region is so small that it can be tried in any case.
  [[nodiscard]] bool is_promising(const Candidate& start, const Candidate& best) const {
    return !start.mesh.triangles.empty() &&
           (start.merit.large < best.merit.large || boundary_.points.size() <= kSmallRegion);
  }

  /// Other goals may lead nearer to the one that was missed. 90 and 30 degrees can be met where
  /// more cannot; and where many angles are large, they are so beside small ones that are forced.
  void aim_elsewhere(Candidate& best) {
    if (best.merit.complete || boundary_.points.size() > kMostPoints) return;
    const Angle right = Angle::degrees(90), third = Angle::degrees(30);
    if (options_.max_angle < right || third < options_.min_angle)
      aim_at(best, std::max(options_.max_angle, right), std::min(options_.min_angle, third));
    for (const double part : {0.25, 0.0}) {
      const auto triangles = static_cast<double>(best.merit.triangles);
      if (static_cast<double>(best.merit.above) <= kMany * triangles) return;
      aim_at(best, options_.max_angle, Angle::radians(part * options_.min_angle.in_radians()));
    }
  }

  void aim_at(Candidate& best, Angle max, Angle min) {
    const auto find = [&] { return best_candidate(); };
    candidates_.take_if_better(best, candidates_.with_goal(Goal::of(max, min), find));
  }

  /// Searches for what is left, if few triangles miss the region's own target, or are above 120
  /// degrees.
  void search_what_is_left(Candidate& best) const {
    const Goal goal = candidates_.goal();
    if (!candidates_.is_done(best))
      candidates_.take_if_better(
          best, candidates_.searched(best, candidates_.own_goal(best.mesh), kEvaluationsForOwn));
    const Goal far{std::max(goal.large, kFarAbove), goal.small, goal.weight};
    if (best.merit.far_above > 0 && far != goal)
      candidates_.take_if_better(best, candidates_.searched(best, far, kEvaluationsForFar));
  }

  [[nodiscard]] RegionMesh reported(const Candidate& candidate) const {
    RegionMesh out = to_region_mesh(candidate.mesh, candidates_.frame(), boundary_.points);
    RegionReport& report = out.report;
    report.id = boundary_.id;
    report.method = candidate.method;
    report.nu_opt = Angle::radians(candidates_.limit().nu);
    report.nu_bound = Angle::radians(candidates_.limit().promised_nu());
    report.forced_above_120 = candidates_.limit().above_120;
    report.forced_above_150 = candidates_.limit().above_150;
    return out;
  }

  const RegionBoundary& boundary_;
  const Options& options_;
  Candidates candidates_;
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
