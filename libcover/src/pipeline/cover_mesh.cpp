// The whole method on one screen:
//
//   Input -> Pslg -> RegionTable -> one RegionBoundary per region -> RegionMeshes -> Mesh
//
// Since no vertex is put on a segment, regions are meshed apart and in parallel, and joined by
// vertex id; results lie in region order, so the mesh does not depend on the schedule.
#include <cover/cover_mesh.hpp>

#include <cover/version.hpp>

#include "covering/measure.hpp"
#include "mesh/stitch.hpp"
#include "pipeline/check_options.hpp"
#include "pipeline/describe_options.hpp"
#include "pipeline/nonobtuse.hpp"
#include "pipeline/region_task.hpp"
#include "pipeline/stage_clock.hpp"
#include "quality/cut_and_improve.hpp"
#include "quality/missed_targets.hpp"
#include "quality/sizes.hpp"
#include "quality/split_interfaces.hpp"
#include "region/pslg.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

/// Tells the caller that a stage begins, unless the run is to stop.
Status begin(std::string_view stage, const Callbacks& callbacks) {
  if (callbacks.stop.stop_requested()) return Error{ErrorCode::cancelled, "interrupted", {}, {}};
  if (callbacks.progress) callbacks.progress({stage, 0, 0});
  return ok();
}

/// Input made clean, without the lower bounds.
Result<Prepared> find_regions(const Input& input, const Options& options,
                              const Callbacks& callbacks, StageClock& clock) {
  if (Status status = check_options(options); !status) return std::move(status).error();
  Prepared prepared;
  Report& report = prepared.report;
  report.provenance = {input.source, COVER_VERSION, describe_options(options)};
  report.unit = input.unit;
  report.scale = input.scale;
  for (const std::string& warning : input.warnings)
    report.notes.push_back({Note::Kind::warning, kVoid, warning, {}});
  if (Status status = begin("clean", callbacks); !status) return std::move(status).error();
  Result<Pslg> pslg = make_pslg(input, options, report);
  if (!pslg) return std::move(pslg).error();
  prepared.pslg = *std::move(pslg);
  clock.note("clean", report.times);
  if (Status status = begin("regions", callbacks); !status) return std::move(status).error();
  Result<RegionTable> table = build_region_table(prepared.pslg, options, report.notes);
  if (!table) return std::move(table).error();
  prepared.table = *std::move(table);
  clock.note("regions", report.times);
  if (Status status = split_interfaces(prepared.pslg, prepared.table, options, report.notes);
      !status) {
    return std::move(status).error();
  }
  report.input_points = prepared.pslg.points.size();
  report.input_segments = prepared.pslg.segments.size();
  report.threads = worker_count(options);
  return prepared;
}

/// Moves what the regions report to the whole, in region order.
void collect_reports(std::vector<RegionMesh>& meshes, Report& report) {
  for (RegionMesh& mesh : meshes) {
    merge(report.quality, mesh.report.quality);
    report.steiner_vertices += mesh.report.steiner_vertices;
    report.regions.push_back(std::move(mesh.report));
  }
}

}  // namespace

Result<Prepared> prepare(const Input& input, const Options& options, const Callbacks& callbacks) {
  StageClock clock;
  Result<Prepared> prepared = find_regions(input, options, callbacks, clock);
  if (!prepared) return prepared;
  Result<std::vector<RegionReport>> limits =
      limit_regions(split_regions(prepared->pslg, prepared->table), options, callbacks);
  if (!limits) return std::move(limits).error();
  prepared->report.regions = *std::move(limits);
  clock.note("limits", prepared->report.times);
  return prepared;
}

Result<Output> cover_mesh(const Input& input, const Options& options, const Callbacks& callbacks) {
  StageClock clock;
  Result<Prepared> prepared = find_regions(input, options, callbacks, clock);
  if (!prepared) return std::move(prepared).error();
  auto& [pslg, table, report] = *prepared;

  auto boundaries = split_regions(pslg, table);
  if (Status status = resolve_sizes(pslg, table, options, boundaries); !status) {
    return std::move(status).error();
  }
  clock.note("split", report.times);
  Result<std::vector<RegionMesh>> meshes =
      options.method == Method::nonobtuse
          ? mesh_nonobtuse(pslg, table, boundaries, options, callbacks)
          : mesh_regions(boundaries, options, callbacks);
  if (!meshes) return std::move(meshes).error();
  if (options.method == Method::quality &&
      cut_and_improve(pslg, table, boundaries, *meshes, options, callbacks.stop, report.notes)) {
    report.input_points = pslg.points.size();
    report.input_segments = pslg.segments.size();
    for (std::size_t r = 0; r < boundaries.size(); ++r) {
      report_again(boundaries[r], options, (*meshes)[r]);
      measure(boundaries[r], (*meshes)[r]);
    }
  }
  clock.note("mesh", report.times);
  if (Status status = begin("stitch", callbacks); !status) return std::move(status).error();
  Mesh mesh = stitch(pslg, table, boundaries, *meshes);
  collect_reports(*meshes, report);
  clock.note("stitch", report.times);
  return Output{std::move(mesh), std::move(pslg), std::move(table), std::move(report)};
}

}  // namespace cover
