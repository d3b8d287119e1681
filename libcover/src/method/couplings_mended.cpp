// Negative couplings that are not forced are left mostly where only the almond method holds the
// bound. Large regions, and those whose own sides forbid the target, are meshed once.
// Tested by tests/unit/method/mesh_one_region_test.cpp.
#include "method/couplings_mended.hpp"

#include <optional>
#include <utility>

#include "mend/couplings/delaunay_within_bound.hpp"
#include "method/method_with_fallback.hpp"
#include "options/intent.hpp"
#include "quality/measure_again.hpp"
#include "region/region_mesh.hpp"
#include "target/report/holds_bound.hpp"

namespace cover {
namespace {

/// Of a region that is meshed with couplings and without, where segments are cut for angles.
constexpr std::size_t kPointsToMeshTwice = 500;

/// Whether angles became much worse than they were: more than a cut of a side is worth, where cuts
/// mend what is wrong.
bool costs_angles(const RegionReport& before, const RegionReport& after) {
  constexpr double kMostDegrees = 10, kLeastPart = 1.0 / 3;
  const Quality &was = before.quality, &is = after.quality;
  return before.bound_held && before.box.negative_inside == 0 &&
         (was.largest_nu.in_degrees() > is.largest_nu.in_degrees() + kMostDegrees ||
          is.smallest.in_radians() < kLeastPart * was.smallest.in_radians());
}

/// What the methods leave of negative couplings that are not forced.
RegionMesh with_couplings_mended(const RegionBoundary& boundary, const Options& options,
                                 const std::stop_token& stop, RegionMesh mesh) {
  if (!couplings_count(options) || stop.stop_requested()) return mesh;
  std::optional<RegionMesh> mended = mend_couplings_within_bound(
      boundary, mesh, stop, CouplingEffort::of(options.effort, options.box_method));
  if (!mended) return mesh;
  if (options.box_method && costs_angles(mesh.report, mended->report)) return mesh;
  report_again(boundary, options, Unreached::unknown, *mended);
  return *std::move(mended);
}

}  // namespace

ProvenMesh method_with_couplings_mended(const RegionBoundary& boundary, const Options& options,
                                        const std::stop_token& stop, const Team& team) {
  ProvenMesh out = method_with_fallback(boundary, options, stop, team);
  if (options.method == Method::quality)
    out.mesh = with_couplings_mended(boundary, options, stop, std::move(out.mesh));
  return out;
}

ProvenMesh better_of_couplings_and_angles(const RegionBoundary& boundary, const Options& options,
                                          const std::stop_token& stop, const Team& team) {
  Options for_angles = options;
  for_angles.couplings = Couplings::last;
  if (options.max_angle <= Angle::degrees(90))
    return method_with_couplings_mended(boundary, for_angles, stop, team);
  ProvenMesh out = method_with_couplings_mended(boundary, options, stop, team);
  const auto above_target = [&](const RegionMesh& mesh) {
    return count_above(all_points(boundary, mesh), mesh.triangles, options.max_angle);
  };
  const std::size_t above = above_target(out.mesh);
  const bool is_forbidden = out.mesh.report.nu_opt < options.max_angle.supplement();
  if (above == 0 || is_forbidden || boundary.points.size() > kPointsToMeshTwice ||
      stop.stop_requested())
    return out;
  ProvenMesh other = method_with_couplings_mended(boundary, for_angles, stop, team);
  return above_target(other.mesh) < above ? std::move(other) : std::move(out);
}

}  // namespace cover
