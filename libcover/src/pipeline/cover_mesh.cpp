// The whole method on one screen:
//
//   Input -> Pslg -> RegionTable -> one RegionBoundary per region -> RegionMeshes -> Mesh
//
// Since no vertex is put on a segment, regions are meshed apart and in parallel, and joined by
// vertex id; results lie in region order, so the mesh does not depend on the schedule.
// Tested by tests/unit/pipeline/cover_mesh_test.cpp.
#include <cover/cover_mesh.hpp>
#include <cover/periodic.hpp>
#include <cover/verify.hpp>

#include <utility>
#include <vector>

#include "cuts/after_meshing/cut_until_met.hpp"
#include "cuts/after_meshing/cut_what_is_left.hpp"
#include "cuts/after_meshing/mesh_with_closed_clefts.hpp"
#include "cuts/after_meshing/thin_cuts.hpp"
#include "cuts/before_meshing/onto_arcs.hpp"
#include "cuts/boxes/cut_negative_couplings.hpp"
#include "cuts/cut_segments.hpp"
#include "cuts/needles/warn_of_needles.hpp"
#include "layers/layer_rules.hpp"
#include "mesh/periodic_nodes.hpp"
#include "mesh/stitch.hpp"
#include "nonobtuse/nonobtuse.hpp"
#include "pipeline/steps.hpp"
#include "sizes/fields/carry_field.hpp"
#include "target/report/collect_reports.hpp"
#include "tasks/begin_stage.hpp"
#include "tasks/by_team.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/followed_run.hpp"
#include "tasks/mesh_regions.hpp"

namespace cover {
namespace {

Status mesh_each_region(Work& work, const Options& options, const Callbacks& callbacks) {
  if (options.method == Method::nonobtuse) return mesh_nonobtuse(work, options, callbacks);
  Result<std::vector<RegionMesh>> meshes = mesh_regions(work.boundaries, options, callbacks);
  if (!meshes) return std::move(meshes).error();
  work.meshes = *std::move(meshes);
  return ok();
}

Status cut_regions(Work& work, const Options& options, const Callbacks& callbacks) {
  return cut_until_met(work, options, callbacks);
}

Status prove_limits(Work& work, const Options& options, const Callbacks& callbacks) {
  return prove_old_limits(work.boundaries, options, callbacks, work.meshes);
}

Status look_at_cuts(Work& work, const Options& options, const Callbacks& /*callbacks*/) {
  Status apart = errors_as_values("check cuts", [&]() -> Status {
    for (const PeriodicRule& rule : work.rules) {
      Result<std::size_t> pairs = verify_periodic_sides(work.pslg, work.table, rule);
      if (!pairs)
        return Error{ErrorCode::meshing_incomplete, pairs.error().message, pairs.error().where,
                     pairs.error().inputs};
    }
    Status sound = check_cuts(work.pslg, work.table, work.report.input_points);
    if (sound) warn_of_needles(work, options, work.report.notes);
    return sound;
  });
  if (apart) warn_of_straight_arcs(work.pslg, work.report.notes);
  return apart;
}

template <class AnyInput>
Result<Output> mesh_input(AnyInput&& input, const Options& asked, const Callbacks& caller) {
  return followed("mesh", caller, [&](const Callbacks& callbacks) -> Result<Output> {
    StageClock clock;
    const Options options = with_layers_of(input, asked);
    Result<Work> work =
        begin_work(std::forward<AnyInput>(input), options, Held::all, callbacks, clock);
    return work ? finish_work(*std::move(work), options, callbacks, clock)
                : std::move(work).error();
  });
}

}  // namespace

Result<Output> finish_work(Work work, const Options& options, const Callbacks& callbacks,
                           StageClock& clock) {
  for (const auto step :
       {mesh_each_region, cut_regions, mesh_with_closed_clefts, cut_negative_couplings, thin_cuts,
        cut_what_is_left, prove_limits, look_at_cuts})
    if (Status status = step(work, options, callbacks); !status) return std::move(status).error();
  clock.note("mesh", work.report.times);
  return stitch_regions(std::move(work), callbacks, clock);
}

Result<Output> stitch_regions(Work work, const Callbacks& callbacks, StageClock& clock) {
  if (Status status = begin_stage("stitch", callbacks); !status) return std::move(status).error();
  Result<Mesh> mesh = by_team("stitch", work.report.threads, [&](const Team& team) {
    return Result<Mesh>(
        stitch(work.pslg, work.table, std::move(work.boundaries), work.meshes, team));
  });
  if (!mesh) return std::move(mesh).error();
  collect_reports(work.meshes, work.report);
  std::vector<PeriodicNodes> periodic = periodic_nodes(work.pslg, work.rules, *mesh);
  CarriedField carried;
  if (work.field) carried = carry_field(*work.field, *mesh, work.report.notes);
  clock.note("stitch", work.report.times);
  return Output{*std::move(mesh),
                std::move(work.pslg),
                std::move(work.table),
                std::move(work.report),
                std::move(periodic),
                std::move(carried.fields),
                {},
                std::move(carried.region_values)};
}

Result<Output> cover_mesh(const Input& input, const Options& asked, const Callbacks& callbacks) {
  return mesh_input(input, asked, callbacks);
}

Result<Output> cover_mesh(Input&& input, const Options& asked, const Callbacks& callbacks) {
  return mesh_input(std::move(input), asked, callbacks);
}

}  // namespace cover
