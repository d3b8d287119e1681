// All regions meshed, in this process or in several.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// What the sides of every region allow at best, without a mesh; in region order.
Result<std::vector<RegionReport>> bound_regions(std::span<const RegionBoundary> boundaries,
                                                const Options& options, const Callbacks& callbacks);

/// Takes the mesh of a region.
///
/// Threads: called from several at a time, each with regions of its own
using RegionSink = std::function<void(std::size_t region, RegionMesh mesh)>;

struct Staying;

/// Meshes and measures every region, as Callbacks::share_out says, and hands each to `sink` when it
/// is done. Once `is_good` is false, no further region is begun. With `staying`, meshes of other
/// processes may stay there.
///
/// Errors: those of for_each_region()
Status mesh_regions_into(
    std::span<const RegionBoundary> boundaries, const Options& options, const Callbacks& callbacks,
    const RegionSink& sink, const std::function<bool()>& is_good = [] { return true; },
    const Staying* staying = nullptr);

/// The same; results in region order.
Result<std::vector<RegionMesh>> mesh_regions(std::span<const RegionBoundary> boundaries,
                                             const Options& options, const Callbacks& callbacks);

/// Proves limits again where RegionMesh::limits_are_old.
///
/// ENSURES: none is old
/// Errors:  those of for_each_region()
Status prove_old_limits(std::span<const RegionBoundary> boundaries, const Options& options,
                        const Callbacks& callbacks, std::span<RegionMesh> meshes);

}  // namespace cover
