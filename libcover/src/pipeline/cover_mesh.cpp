// The whole method on one screen:
//
//   Input -> Pslg -> RegionTable -> one RegionBoundary per region -> RegionMeshes -> Mesh
//
// Since no vertex is put on a segment, regions are meshed apart and in parallel, and joined by
// vertex id; results lie in region order, so the mesh does not depend on the schedule.
#include <cover/cover_mesh.hpp>

#include "covering/measure.hpp"
#include "mesh/stitch.hpp"
#include "pipeline/find_regions.hpp"
#include "pipeline/nonobtuse.hpp"
#include "pipeline/region_task.hpp"
#include "quality/cut_and_improve.hpp"
#include "quality/missed_targets.hpp"
#include "quality/sizes.hpp"
#include "region/region_graph.hpp"

namespace cover {

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
  warn_of_sizes(pslg, options, boundaries, report.notes);
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
  if (Status status = begin_stage("stitch", callbacks); !status) return std::move(status).error();
  Mesh mesh = stitch(pslg, table, boundaries, *meshes);
  collect_reports(*meshes, report);
  clock.note("stitch", report.times);
  return Output{std::move(mesh), std::move(pslg), std::move(table), std::move(report)};
}

}  // namespace cover
