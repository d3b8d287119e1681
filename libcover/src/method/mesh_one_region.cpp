// The method asked for comes first; what breaks the mesh or the bound falls back to another, which
// is told (method_with_fallback); then couplings are mended (couplings_mended), the rest is joined
// to its layers, and limits are proven (proven_limits).
// Tested by tests/unit/method/mesh_one_region_test.cpp.
#include "method/mesh_one_region.hpp"

#include <utility>

#include "base/stage_clock.hpp"
#include "layers/layered_region.hpp"
#include "method/couplings_mended.hpp"
#include "method/method_with_fallback.hpp"
#include "method/proven_limits.hpp"
#include "quality/measure_again.hpp"

namespace cover {
namespace {

/// Whether targets come before couplings in regions without layers: segments may be cut where they
/// are missed.
bool targets_come_first(const Options& options) {
  return options.split_interfaces && !options.box_method &&
         options.couplings == Couplings::automatic && options.method == Method::quality;
}

/// The region, and its layers if it has some.
ProvenMesh with_layers(const RegionBoundary& boundary, const Options& options,
                       const std::stop_token& stop, const Team& team) {
  if (!has_layers(boundary)) {
    return targets_come_first(options)
               ? better_of_couplings_and_angles(boundary, options, stop, team)
               : method_with_couplings_mended(boundary, options, stop, team);
  }
  const auto mesh_rest = [&](const RegionBoundary& rest, const Options& for_rest) {
    return method_with_fallback(rest, for_rest, stop, team).mesh;
  };
  RegionMesh mesh = mesh_with_layers(boundary, options, mesh_rest, stop);
  if (mesh.layer_triangles > 0 && options.method == Method::quality && !stop.stop_requested())
    report_again(boundary, options, Unreached::unknown, mesh);
  return {std::move(mesh)};
}

}  // namespace

RegionMesh mesh_one_region(const RegionBoundary& boundary, const Options& options,
                           const std::stop_token& stop, const Team& team) {
  const StageClock clock;
  ProvenMesh made = with_layers(boundary, options, stop, team);
  RegionReport& report = made.mesh.report;
  if (!stop.stop_requested())
    report.limits = proven_limits(boundary, made.mesh, options, team, std::move(made.proof));
  report.seconds = clock.seconds();
  return std::move(made.mesh);
}

}  // namespace cover
