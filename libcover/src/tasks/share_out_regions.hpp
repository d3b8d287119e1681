// Regions for other processes: see cover/share_out.hpp.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "base/team.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"
#include "tasks/between_processes/region_bytes.hpp"

namespace cover {

/// How meshes may stay in the processes that make them.
struct Staying {
  /// Offers it, see RegionJobs::offer_to_keep(); whether that was agreed to.
  std::function<bool(const std::function<bool(const Bytes& how)>& offer)> offer;
  /// The numbers that the vertices of a region have in the whole mesh.
  std::function<std::vector<VertexId>(std::size_t region)> vertices;
  /// Takes what is told of a mesh that stays.
  std::function<void(std::size_t region, KeptMesh mesh)> sink;
};

/// Has every region meshed by Callbacks::share_out, and hands each to `sink` when it is done, or
/// what is told of it to staying.sink. Once `is_good` is false, this process begins no further
/// region.
///
/// REQUIRES: callbacks.share_out
/// Errors:   as mesh_regions_into(), and those of share_out
Status share_out_regions(std::span<const RegionBoundary> boundaries, const Options& options,
                         const Callbacks& callbacks,
                         const std::function<void(std::size_t region, RegionMesh mesh)>& sink,
                         const std::function<bool()>& is_good, const Staying* staying = nullptr);

/// Meshes a region, of which Staying::vertices are sent, for another process; `keep` takes the mesh
/// and tells of it.
Bytes keep_region_bytes(
    std::span<const std::byte> boundary, const Options& options, const Team& team,
    const std::function<KeptMesh(const RegionBoundary& boundary, RegionMesh mesh)>& keep);

}  // namespace cover
