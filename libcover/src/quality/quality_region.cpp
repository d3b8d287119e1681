// docs/quality_method.md from its step 1 (frame) to 11 (report): steps of a plan make candidates,
// and the best is kept (plan/plan). By Prefer::largest, and with all effort: where the goal is
// missed still, the same again with other goals; where few triangles miss the region's own target
// or are above 120 degrees, a search for these alone.
// Tested by tests/unit/quality/quality_region_test.cpp.
#include "quality/quality_region.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "cdt/couplings.hpp"
#include "geom/predicates.hpp"
#include "options/intent.hpp"
#include "quality/effort/effort.hpp"
#include "quality/fault/missed_sizes.hpp"
#include "quality/fault/missed_targets.hpp"
#include "quality/mutable/to_region_mesh.hpp"
#include "quality/plan/candidates.hpp"
#include "quality/plan/plan.hpp"
#include "target/report/fill_report.hpp"
#include "target/report/holds_bound.hpp"

namespace cover {
namespace {

constexpr std::size_t kMostHandedOver = 10'000;  ///< points of a region whose proof is kept

/// One region in one frame.
class RegionWork {
 public:
  RegionWork(const RegionBoundary& boundary, const Options& options, const std::stop_token& stop,
             bool shifted, const Sharing& sharing, std::optional<RegionMesh> almonds)
      : boundary_(boundary),
        options_(options),
        candidates_(boundary, options, stop, shifted, sharing, std::move(almonds)) {}

  /// ENSURES: no triangles if rounding on the way back to the plane turned one over, or the run is
  ///          to stop
  RegionMesh run() {
    Candidate best = best_candidate();
    const bool goes_on =
        options_.effort == Effort::thorough ||
        (options_.effort == Effort::normal && preferred(options_) == Prefer::largest);
    if (goes_on && !candidates_.has_sizes() && !candidates_.is_tiny() &&
        !candidates_.outlook().has_no_room()) {
      aim_elsewhere(best);
      if (!is_mended_by_cuts()) search_what_is_left(best);
    }
    if (candidates_.must_stop()) return {};
    RegionMesh out = reported(best);
    const Goal& goal = candidates_.goal();
    if (!best.mesh->goal().has_same_angles(goal)) best.mesh.change().set_goal(goal);
    out.report.notes = missed_targets(
        *best.mesh, boundary_, options_,
        {candidates_.limit(), unreached(), candidates_.frame().origin()}, candidates_.team());
    if (candidates_.has_sizes()) {
      if (auto note = missed_sizes(boundary_, out)) out.report.notes.push_back(*std::move(note));
    }
    return out;
  }

  /// The region's proof, if it is worth its memory until the mesh has been checked.
  [[nodiscard]] std::unique_ptr<RegionProof> take_proof() {
    if (boundary_.points.size() > kMostHandedOver) return nullptr;
    return candidates_.outlook().take_proof();
  }
  [[nodiscard]] std::optional<RegionMesh> take_almonds() { return candidates_.take_almonds(); }
  [[nodiscard]] bool is_shifted() const { return candidates_.frame().is_shifted(); }

 private:
  /// Towards right angles cuts mend what is left for less: such searches took half of the time of
  /// 1,000 parcels 1 mm apart and of the counties of Virginia, for as many triangles and no fewer
  /// obtuse ones.
  [[nodiscard]] bool is_mended_by_cuts() const {
    return options_.effort == Effort::normal && is_cut_until_met(options_) &&
           options_.max_angle == Angle::degrees(90);
  }

  [[nodiscard]] Unreached unreached() const {
    if (candidates_.outlook().has_no_room()) return Unreached::couplings;
    return candidates_.is_budget_used_up() ? Unreached::budget : Unreached::unknown;
  }

  Candidate best_candidate() {
    return run_plan(plan_for(options_, candidates_.has_sizes()), candidates_);
  }

  /// Other goals may lead nearer to the one that was missed. 90 and 30 degrees can be met where
  /// more cannot; and where many angles are large, they are so beside small ones that are forced.
  void aim_elsewhere(Candidate& best) {
    if (best.merit.complete || boundary_.points.size() > effort::kPointsToAimElsewhere) return;
    const Angle right = Angle::degrees(90), third = Angle::degrees(30);
    if (options_.max_angle < right || third < options_.min_angle)
      aim_at(best, std::max(options_.max_angle, right), std::min(options_.min_angle, third));
    for (const double part : {0.25, 0.0}) {
      const auto triangles = static_cast<double>(best.merit.triangles);
      if (static_cast<double>(best.merit.above) <= effort::kShareToEaseSmall * triangles) return;
      aim_at(best, options_.max_angle, Angle::radians(part * options_.min_angle.in_radians()));
    }
  }

  void aim_at(Candidate& best, Angle max, Angle min) {
    const auto find = [&] { return best_candidate(); };
    candidates_.ranking().take_if_better(
        best, candidates_.with_goal(candidates_.goal_for(max, min), find));
  }

  /// Searches for what is left, if few triangles miss the region's own target, or are above 120
  /// degrees.
  void search_what_is_left(Candidate& best) const {
    const Goal goal = candidates_.goal();
    if (!candidates_.is_done(best))
      candidates_.ranking().take_if_better(
          best,
          candidates_.searched(best, candidates_.own_goal(*best.mesh), effort::kSearchForOwn));
    const Goal far = goal.with(std::max(goal.large, kFarAbove), goal.small, goal.weight);
    if (best.merit.far_above > 0 && far != goal)
      candidates_.ranking().take_if_better(best,
                                           candidates_.searched(best, far, effort::kSearchForFar));
  }

  [[nodiscard]] RegionMesh reported(const Candidate& candidate) const {
    RegionMesh out =
        to_region_mesh(*candidate.mesh, candidates_.frame(), boundary_.points, candidates_.team());
    if (couplings_count(options_) && has_negative(*candidate.mesh)) flip_in_the_plane(out);
    RegionReport& report = out.report;
    report.id = boundary_.id;
    report.method = candidate.method;
    report.has_no_room = candidates_.outlook().has_no_room();
    set_bound(candidates_.limit(), report);
    return out;
  }

  /// Whether an inner edge has a negative coupling in the plane: rounding on the way back may have
  /// made it so.
  [[nodiscard]] bool has_negative(const MutableMesh& mesh) const {
    const auto at = [&](std::uint32_t v) {
      return v < boundary_.points.size() ? boundary_.points[v]
                                         : candidates_.frame().restore(mesh.points[v]);
    };
    const auto is_negative = [&](std::uint32_t t) {
      if (mesh.is_hole(t)) return false;
      const auto& [v, n] = mesh.triangles[t];
      for (const Corner i : kCorners) {
        if (is_side(n[i]) || n[i] < t) continue;
        const MeshTriangle& other = mesh.triangles[n[i]];
        const std::uint32_t beyond =
            other.v[static_cast<std::size_t>(other.edge_from(v[i.previous()]))];
        if (in_circle(at(v[0]), at(v[1]), at(v[2]), at(beyond)) == Sign::positive) return true;
      }
      return false;
    };
    std::atomic<bool> found = false;
    candidates_.team().each_range(mesh.triangles.size(), kItemsAtATime,
                                  [&](std::size_t first, std::size_t last) {
                                    for (std::size_t t = first; t < last && !found; ++t) {
                                      if (is_negative(static_cast<std::uint32_t>(t))) found = true;
                                    }
                                  });
    return found;
  }

  void flip_in_the_plane(RegionMesh& out) const {
    std::vector<IndexTriple> triangles = out.triangles;
    const std::vector<Point> points = all_points(boundary_, out);
    if (make_delaunay(points, triangles, boundary_.sides) == 0) return;
    if (holds_bound(points, triangles, Angle::radians(candidates_.limit().promised_nu())))
      out.triangles = std::move(triangles);
  }

  const RegionBoundary& boundary_;
  const Options& options_;
  Candidates candidates_;
};

}  // namespace

ProvenMesh quality_region(const RegionBoundary& boundary, const Options& options,
                          const std::stop_token& stop, const Sharing& sharing,
                          std::optional<RegionMesh> almonds) {
  RegionWork shifted(boundary, options, stop, true, sharing, std::move(almonds));
  ProvenMesh out{shifted.run()};
  out.proof = shifted.take_proof();
  out.almonds = shifted.take_almonds();
  if (out.mesh.triangles.empty() && shifted.is_shifted() && !stop.stop_requested()) {
    RegionWork in_the_plane(boundary, options, stop, false, sharing, std::move(out.almonds));
    out.mesh = in_the_plane.run();
    out.almonds = in_the_plane.take_almonds();
  }
  return out;
}

}  // namespace cover
