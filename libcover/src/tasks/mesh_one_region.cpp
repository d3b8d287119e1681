// The method asked for comes first; what breaks the mesh or the bound falls back to another, which
// is told; then couplings are mended and limits proven.
// Tested by tests/unit/tasks/mesh_one_region_test.cpp.
#include "tasks/mesh_one_region.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/judged_angle.hpp>

#include "almond/almond_region.hpp"
#include "almond/chords.hpp"
#include "base/faults/internal_fault.hpp"
#include "cdt/region_cdt.hpp"
#include "layers/layered_region.hpp"
#include "limits/region_limits.hpp"
#include "mend/couplings/delaunay_within_bound.hpp"
#include "quality/fault/merit.hpp"
#include "quality/measure_again.hpp"
#include "quality/quality_region.hpp"
#include "region/triangulation_of.hpp"
#include "target/angle_limit.hpp"
#include "target/report/fill_report.hpp"
#include "target/report/holds_bound.hpp"
#include "target/whole_mesh.hpp"
#include "tasks/stage_clock.hpp"

namespace cover {
namespace {

/// Of a region that is meshed with couplings and without, where segments are cut for angles.
constexpr std::size_t kPointsToMeshTwice = 500;

/// From so many on, several threads judge a mesh: some tenths of a second of work.
constexpr std::size_t kManyTriangles = 100'000;

std::unique_ptr<RegionProof> proof_of(const RegionBoundary& boundary) {
  return std::make_unique<RegionProof>(triangulation_of(boundary));
}

using RegionMethod = ProvenMesh (*)(const RegionBoundary&, const Options&, const std::stop_token&,
                                    const Team&);

/// A mesh, and why it does not fill its region, if it does not: then it has no triangles.
struct Attempt : ProvenMesh {
  std::optional<BoundaryFault> fault{};
};

/// What a method made of the region, measured, and its fault.
Attempt judged(ProvenMesh made, const RegionBoundary& boundary, const std::stop_token& stop,
               const Team& team) {
  Attempt out{std::move(made)};
  if (stop.stop_requested()) return out;
  RegionMesh& mesh = out.mesh;
  const std::vector<Point> points = all_points(boundary, mesh);
  // What the limits will need, meanwhile: it takes no longer than that by itself.
  const auto& notes = mesh.report.notes;
  const bool looks_ahead =
      !out.proof && team.workers() > 1 && mesh.triangles.size() >= kManyTriangles &&
      std::any_of(notes.begin(), notes.end(),
                  [](const Note& note) { return note.kind == Note::Kind::target_missed; });
  // Large meshes are measured meanwhile, too, and once more if they are faulty.
  const bool measures_ahead = team.workers() > 1 && mesh.triangles.size() >= kManyTriangles;
  std::vector<std::uint32_t> across;
  const RegionReport unmeasured = measures_ahead ? mesh.report : RegionReport();
  team.each(looks_ahead      ? 3
            : measures_ahead ? 2
                             : 1,
            [&](std::size_t k) {
              if (k == 2) {
                out.proof = proof_of(boundary);
              } else if (k == 1) {
                fill_report(boundary, mesh, team);
              } else {
                out.fault = find_fault({points, mesh.triangles, boundary.sides, boundary.segments,
                                        boundary.points.size()},
                                       team, measures_ahead ? nullptr : &across);
              }
            });
  if (out.fault) {
    mesh.steiner.clear();
    mesh.triangles.clear();
    across.clear();
    if (measures_ahead) mesh.report = unmeasured;
  }
  if (out.fault || !measures_ahead) fill_report(boundary, mesh, team, std::move(across));
  return out;
}

Attempt attempt(RegionMethod method, const RegionBoundary& boundary, const Options& options,
                const std::stop_token& stop, const Team& team) {
  return judged(method(boundary, options, stop, team), boundary, stop, team);
}

ProvenMesh by_quality(const RegionBoundary& boundary, const Options& options,
                      const std::stop_token& stop, const Team& team) {
  return quality_region(boundary, options, stop, {team});
}

ProvenMesh by_almonds(const RegionBoundary& boundary, const Options& options,
                      const std::stop_token& stop, const Team& team) {
  return {almond_region(boundary, options, stop, team)};
}

/// The constrained Delaunay triangulation, which no rounding can break.
ProvenMesh plain_region(const RegionBoundary& boundary, const Options&, const std::stop_token&,
                        const Team& team) {
  const Triangulation cdt = triangulation_of(boundary, team);
  RegionMesh mesh;
  mesh.report.id = boundary.id;
  mesh.report.method = "cdt";
  set_limits(angle_limit(cdt, boundary.sides, boundary.segments), mesh.report);
  mesh.triangles.reserve(cdt.triangles.size());
  for (const Triangle& t : cdt.triangles) mesh.triangles.push_back(t.v);
  return {std::move(mesh)};
}

/// What became of a method that was not used.
Note note_of_fallback(const RegionBoundary& boundary, const Attempt& attempt, std::string_view from,
                      std::string_view to) {
  const RegionReport& report = attempt.mesh.report;
  std::string what = attempt.fault
                         ? "broke the mesh (" + attempt.fault->what + ")"
                         : fmt::format("put an angle of {:.12g} degrees beyond the bound",
                                       report.quality.largest_nu.supplement().in_degrees());
  return {Note::Kind::fallback, boundary.id,
          fmt::format("region {}: with the {} method, rounding {}; the {} was used instead",
                      boundary.id.value(), from, what, to),
          attempt.fault ? attempt.fault->where : std::vector<Point>{}};
}

/// What no mesh of the region can have better. Hull sides may be split, so that nothing is known of
/// meshes there. The almond method aims at the bound and at no target: limits beside one would take
/// twice its time (`cover check` tells them of any mesh). With little effort little is asked.
RegionLimits proven_limits(const RegionBoundary& boundary, const RegionMesh& mesh,
                           const Options& options, const Team& team,
                           std::unique_ptr<RegionProof> proof) {
  const Quality& quality = mesh.report.quality;
  if (quality.triangles == 0 || options.method != Method::quality || boundary.has_hull_sides())
    return {};
  const ReachedAngles reached{judged_nu(quality), quality.smallest};
  const ReachedAngles wanted{options.max_angle.supplement(), options.min_angle};
  if (meets(reached, wanted)) return region_limits({}, reached, wanted);
  if (mesh.report.has_no_room && mesh.layer_triangles == 0)
    return limits_by_couplings(reached, wanted);
  const ProofEffort effort = options.effort == Effort::fast     ? ProofEffort::brief()
                             : options.effort == Effort::normal ? ProofEffort::usual()
                                                                : ProofEffort();
  AnglesAround around =
      AnglesAround::of(all_points(boundary, mesh), mesh.triangles, boundary.points.size());
  if (!proof) proof = proof_of(boundary);
  return region_limits(proof->prover(team), reached, wanted, effort, std::move(around));
}

/// The method asked for; where that misses the bound, the other one if it is better. It is rounding
/// that makes them miss: the one in a region as flat as coordinates can be, the other where an
/// improved triangle lies just inside the bound in the frame in which it was improved.
/// The proof is of the method asked for.
ProvenMesh mesh_region(const RegionBoundary& boundary, const Options& options,
                       const std::stop_token& stop, const Team& team) {
  const bool quality = options.method == Method::quality;
  const std::string_view asked = quality ? "quality" : "almond";
  const std::string_view second = quality ? "almond" : "quality";
  Attempt first = attempt(quality ? by_quality : by_almonds, boundary, options, stop, team);
  const bool promised = CutRule{options.paper, options.pieces}.promises_bound();
  const bool will_do =
      !first.fault && (first.mesh.report.bound_held || !promised || boundary.is_part);
  if (stop.stop_requested() || will_do) return first;
  const auto by_the_other = [&]() -> ProvenMesh {
    if (!quality) return quality_region(boundary, options, stop, {team}, first.mesh);
    if (first.almonds) return {*std::exchange(first.almonds, std::nullopt)};
    return by_almonds(boundary, options, stop, team);
  };
  Attempt other = judged(by_the_other(), boundary, stop, team);
  other.proof = std::move(first.proof);
  if (stop.stop_requested()) return other;
  if (first.fault && other.fault) {
    Attempt plain = attempt(plain_region, boundary, options, stop, team);
    if (plain.fault) throw InternalFault(plain.fault->what, std::move(plain.fault->where));
    plain.mesh.report.notes.push_back(
        note_of_fallback(boundary, first, asked, "constrained Delaunay triangulation"));
    plain.mesh.report.notes.push_back(
        note_of_fallback(boundary, other, second, "constrained Delaunay triangulation"));
    plain.proof = std::move(other.proof);
    return plain;
  }
  if (!first.fault && (other.fault || other.mesh.report.quality.largest_nu <=
                                          first.mesh.report.quality.largest_nu)) {
    first.proof = std::move(other.proof);
    return first;
  }
  other.mesh.report.notes.push_back(
      note_of_fallback(boundary, first, asked, fmt::format("{} method", second)));
  return other;
}

/// Whether angles became much worse than they were: more than a cut of a side is worth, where cuts
/// mend what is wrong.
bool costs_angles(const RegionReport& before, const RegionReport& after) {
  constexpr double kMostDegrees = 10, kLeastPart = 1.0 / 3;
  const Quality &was = before.quality, &is = after.quality;
  return before.bound_held && before.box.negative_inside == 0 &&
         (was.largest_nu.in_degrees() > is.largest_nu.in_degrees() + kMostDegrees ||
          is.smallest.in_radians() < kLeastPart * was.smallest.in_radians());
}

/// What the methods leave of negative couplings that are not forced: mostly where only the almond
/// method holds the bound.
RegionMesh with_couplings_mended(const RegionBoundary& boundary, const Options& options,
                                 const std::stop_token& stop, RegionMesh mesh) {
  if (!minds_couplings(options) || stop.stop_requested()) return mesh;
  std::optional<RegionMesh> mended = mend_couplings_within_bound(
      boundary, mesh, stop, CouplingEffort::of(options.effort, options.box_method));
  if (!mended) return mesh;
  if (options.box_method && costs_angles(mesh.report, mended->report)) return mesh;
  report_again(boundary, options, false, *mended);
  return *std::move(mended);
}

/// A region without layers.
ProvenMesh mesh_and_mend(const RegionBoundary& boundary, const Options& options,
                         const std::stop_token& stop, const Team& team) {
  ProvenMesh out = mesh_region(boundary, options, stop, team);
  if (options.method == Method::quality)
    out.mesh = with_couplings_mended(boundary, options, stop, std::move(out.mesh));
  return out;
}

/// Whether targets come before couplings in regions without layers: segments may be cut where they
/// are missed.
bool targets_come_first(const Options& options) {
  return options.split_interfaces && !options.box_method &&
         options.couplings == Couplings::automatic && options.method == Method::quality;
}

/// A region whose segments are cut where angles are left above the target: without negative
/// couplings, if that leaves no more angles to cut for. Large regions, and those whose own sides
/// forbid the target, are meshed once.
ProvenMesh mesh_for_cuts(const RegionBoundary& boundary, const Options& options,
                         const std::stop_token& stop, const Team& team) {
  Options for_angles = options;
  for_angles.couplings = Couplings::last;
  if (options.max_angle <= Angle::degrees(90))
    return mesh_and_mend(boundary, for_angles, stop, team);
  ProvenMesh out = mesh_and_mend(boundary, options, stop, team);
  const auto above_target = [&](const RegionMesh& mesh) {
    return count_above(all_points(boundary, mesh), mesh.triangles, options.max_angle);
  };
  const std::size_t above = above_target(out.mesh);
  const bool is_forbidden = out.mesh.report.nu_opt < options.max_angle.supplement();
  if (above == 0 || is_forbidden || boundary.points.size() > kPointsToMeshTwice ||
      stop.stop_requested())
    return out;
  ProvenMesh other = mesh_and_mend(boundary, for_angles, stop, team);
  return above_target(other.mesh) < above ? std::move(other) : std::move(out);
}

/// The region, and its layers if it has some.
ProvenMesh mesh_with_its_layers(const RegionBoundary& boundary, const Options& options,
                                const std::stop_token& stop, const Team& team) {
  if (!has_layers(boundary)) {
    return targets_come_first(options) ? mesh_for_cuts(boundary, options, stop, team)
                                       : mesh_and_mend(boundary, options, stop, team);
  }
  const auto mesh_rest = [&](const RegionBoundary& rest, const Options& for_rest) {
    return mesh_region(rest, for_rest, stop, team).mesh;
  };
  RegionMesh mesh = mesh_with_layers(boundary, options, mesh_rest, stop);
  if (mesh.layer_triangles > 0 && options.method == Method::quality && !stop.stop_requested())
    report_again(boundary, options, false, mesh);
  return {std::move(mesh)};
}

}  // namespace

RegionMesh mesh_one_region(const RegionBoundary& boundary, const Options& options,
                           const std::stop_token& stop, const Team& team) {
  const StageClock clock;
  ProvenMesh made = mesh_with_its_layers(boundary, options, stop, team);
  RegionReport& report = made.mesh.report;
  if (!stop.stop_requested())
    report.limits = proven_limits(boundary, made.mesh, options, team, std::move(made.proof));
  report.seconds = clock.seconds();
  return std::move(made.mesh);
}

}  // namespace cover
