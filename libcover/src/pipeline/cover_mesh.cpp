// The whole method on one screen:
//
//   Input -> Pslg -> RegionTable -> one RegionBoundary per region -> RegionMeshes -> Mesh
//
// Since no vertex is put on a segment, regions are meshed apart and in parallel, and joined by
// vertex id; results lie in region order, so the mesh does not depend on the schedule.
#include <cover/cover_mesh.hpp>

#include "base/out_of_memory.hpp"
#include "cuts/cut_for_boxes.hpp"
#include "cuts/cut_segments.hpp"
#include "cuts/cut_until_met.hpp"
#include "cuts/onto_arcs.hpp"
#include "cuts/thin_cuts.hpp"
#include "layers/layer_rules.hpp"
#include "mesh/periodic_nodes.hpp"
#include "mesh/stitch.hpp"
#include "pipeline/find_regions.hpp"
#include "pipeline/mesh_prepared.hpp"
#include "pipeline/nonobtuse.hpp"
#include "region/region_graph.hpp"
#include "sizes/carry_field.hpp"
#include "sizes/expected_triangles.hpp"
#include "sizes/sizes.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/region_task.hpp"

namespace cover {

Result<Prepared> prepare(const Input& input, const Options& asked, const Callbacks& callbacks) {
  return memory_as_value("prepare", [&]() -> Result<Prepared> {
    StageClock clock;
    const Options options = with_layers_of(input, asked);
    Result<Prepared> prepared = find_regions(input, options, callbacks, clock);
    if (!prepared) return prepared;
    Result<std::vector<RegionReport>> limits =
        limit_regions(split_regions(prepared->pslg, prepared->table), options, callbacks);
    if (!limits) return std::move(limits).error();
    prepared->report.regions = *std::move(limits);
    clock.note("limits", prepared->report.times);
    return prepared;
  });
}

Result<std::vector<RegionBoundary>> split_prepared(Prepared& prepared, const Options& options,
                                                   bool memory_counts, StageClock& clock) {
  const Pslg& pslg = prepared.pslg;
  const RegionTable& table = prepared.table;
  std::vector<RegionBoundary> boundaries;
  Status sized = errors_as_values("split", [&] {
    boundaries = split_regions(pslg, table);
    Status resolved = resolve_sizes(pslg, table, options, boundaries);
    if (resolved) resolved = resolve_layers(pslg, table, options, boundaries);
    return resolved ? check_expected_triangles(table, boundaries, options,
                                               memory_for_mesh(memory_counts))
                    : resolved;
  });
  if (!sized) return std::move(sized).error();
  warn_of_sizes(pslg, options, boundaries, prepared.report.notes);
  clock.note("split", prepared.report.times);
  return boundaries;
}

Result<Output> mesh_prepared(Prepared prepared, std::vector<RegionBoundary> boundaries,
                             const std::vector<PeriodicRule>& rules,
                             const std::shared_ptr<const PlaneField>& field, const Options& options,
                             const Callbacks& callbacks, StageClock& clock) {
  Pslg& pslg = prepared.pslg;
  RegionTable& table = prepared.table;
  Report& report = prepared.report;
  Result<std::vector<RegionMesh>> meshes =
      options.method == Method::nonobtuse
          ? mesh_nonobtuse(pslg, table, boundaries, options, callbacks)
          : mesh_regions(boundaries, options, callbacks);
  if (!meshes) return std::move(meshes).error();
  Status met = cut_until_met(prepared, boundaries, *meshes, options, callbacks);
  if (!met) return std::move(met).error();
  Status coupled = cut_until_coupled(prepared, boundaries, *meshes, options, callbacks);
  if (!coupled) return std::move(coupled).error();
  Status thinned = thin_cuts(prepared, boundaries, *meshes, options, callbacks);
  if (!thinned) return std::move(thinned).error();
  Status apart =
      errors_as_values("check cuts", [&] { return check_cuts(pslg, report.uncut_points); });
  if (!apart) return std::move(apart).error();
  warn_of_straight_arcs(pslg, report.notes);
  clock.note("mesh", report.times);
  if (Status status = begin_stage("stitch", callbacks); !status) return std::move(status).error();
  Result<Mesh> mesh = errors_as_values(
      "stitch", [&] { return Result<Mesh>(stitch(pslg, table, std::move(boundaries), *meshes)); });
  if (!mesh) return std::move(mesh).error();
  collect_reports(*meshes, report);
  std::vector<PeriodicNodes> periodic = periodic_nodes(pslg, rules, *mesh);
  std::vector<PlaneField::Array> fields;
  if (field) fields = carry_field(*field, *mesh, report.notes);
  clock.note("stitch", report.times);
  return Output{*std::move(mesh),  std::move(pslg),     std::move(table),
                std::move(report), std::move(periodic), std::move(fields)};
}

namespace {

Result<Output> mesh_found(Result<Prepared> prepared, const std::vector<PeriodicRule>& rules,
                          const std::shared_ptr<const PlaneField>& field, const Options& options,
                          const Callbacks& callbacks, StageClock& clock) {
  if (!prepared) return std::move(prepared).error();
  Result<std::vector<RegionBoundary>> boundaries = split_prepared(*prepared, options, true, clock);
  if (!boundaries) return std::move(boundaries).error();
  return mesh_prepared(*std::move(prepared), *std::move(boundaries), rules, field, options,
                       callbacks, clock);
}

}  // namespace

Result<Output> cover_mesh(const Input& input, const Options& asked, const Callbacks& callbacks) {
  return memory_as_value("mesh", [&]() -> Result<Output> {
    StageClock clock;
    const Options options = with_layers_of(input, asked);
    return mesh_found(find_regions(input, options, callbacks, clock),
                      periodic_rules(input, options), input.field, options, callbacks, clock);
  });
}

Result<Output> cover_mesh(Input&& input, const Options& asked, const Callbacks& callbacks) {
  return memory_as_value("mesh", [&]() -> Result<Output> {
    StageClock clock;
    const Options options = with_layers_of(input, asked);
    const std::vector<PeriodicRule> rules = periodic_rules(input, options);
    const std::shared_ptr<const PlaneField> field = input.field;
    Result<Prepared> prepared = find_regions(std::move(input), options, callbacks, clock);
    return mesh_found(std::move(prepared), rules, field, options, callbacks, clock);
  });
}

}  // namespace cover
