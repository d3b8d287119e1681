// Regions for other processes: see cover/share_out.hpp.
#pragma once

#include <functional>
#include <span>

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "region/region_boundary.hpp"
#include "target/region_mesh.hpp"

namespace cover {

/// Has every region meshed by Callbacks::share_out, and hands each to `sink` when it is done.
///
/// REQUIRES: callbacks.share_out
/// Errors:   as mesh_regions_into(), and those of share_out
Status share_out_regions(std::span<const RegionBoundary> boundaries, const Options& options,
                         const Callbacks& callbacks,
                         const std::function<void(std::size_t region, RegionMesh mesh)>& sink);

}  // namespace cover
