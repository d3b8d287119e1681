// See mesh_regions.hpp. Tested by tests/unit/pipeline/cover_mesh_test.cpp and share_out_test.cpp
// beside it.
#include "tasks/mesh_regions.hpp"

#include <algorithm>
#include <utility>

#include "method/mesh_one_region.hpp"
#include "method/proven_limits.hpp"
#include "region/triangulation_of.hpp"
#include "target/angle_limit.hpp"
#include "target/report/fill_report.hpp"
#include "tasks/for_each_region.hpp"
#include "tasks/share_out_regions.hpp"

namespace cover {

Result<std::vector<RegionReport>> bound_regions(std::span<const RegionBoundary> boundaries,
                                                const Options& options,
                                                const Callbacks& callbacks) {
  std::vector<RegionReport> reports(boundaries.size());
  Status status =
      for_each_region(boundaries, worker_count(options), "limits", callbacks, [&](std::size_t k) {
        const RegionBoundary& boundary = boundaries[k];
        const Triangulation cdt = triangulation_of(boundary);
        set_bound(angle_limit(cdt, boundary.sides, boundary.segments), reports[k]);
        reports[k].id = boundary.id;
        reports[k].input_vertices = boundary.points.size();
      });
  if (!status) return std::move(status).error();
  return reports;
}

Status mesh_regions_into(std::span<const RegionBoundary> boundaries, const Options& options,
                         const Callbacks& callbacks, const RegionSink& sink,
                         const std::function<bool()>& is_good, const Staying* staying) {
  if (callbacks.share_out)
    return share_out_regions(boundaries, options, callbacks, sink, is_good, staying);
  return for_each_region(boundaries, worker_count(options), "mesh", callbacks,
                         [&](std::size_t k, const Team& team) {
                           if (is_good())
                             sink(k, mesh_one_region(boundaries[k], options, callbacks.stop, team));
                         });
}

Result<std::vector<RegionMesh>> mesh_regions(std::span<const RegionBoundary> boundaries,
                                             const Options& options, const Callbacks& callbacks) {
  std::vector<RegionMesh> meshes(boundaries.size());
  Status status =
      mesh_regions_into(boundaries, options, callbacks,
                        [&](std::size_t k, RegionMesh mesh) { meshes[k] = std::move(mesh); });
  if (!status) return std::move(status).error();
  return meshes;
}

Status prove_old_limits(std::span<const RegionBoundary> boundaries, const Options& options,
                        const Callbacks& callbacks, std::span<RegionMesh> meshes) {
  const auto is_old = [](const RegionMesh& mesh) { return mesh.limits_are_old; };
  if (std::none_of(meshes.begin(), meshes.end(), is_old)) return ok();
  return for_each_region(
      boundaries, worker_count(options), "limits", callbacks, [&](std::size_t k, const Team& team) {
        RegionMesh& mesh = meshes[k];
        if (!std::exchange(mesh.limits_are_old, false)) return;
        mesh.report.limits = proven_limits(boundaries[k], mesh, options, team, nullptr);
      });
}

}  // namespace cover
