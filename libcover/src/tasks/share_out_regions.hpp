// Regions for other processes: see cover/share_out.hpp.
#pragma once

#include <span>
#include <vector>

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "region/region_boundary.hpp"
#include "target/region_mesh.hpp"

namespace cover {

/// Has every region meshed by Callbacks::share_out; results in region order.
///
/// REQUIRES: callbacks.share_out
/// Errors:   as mesh_regions(), and those of share_out
Result<std::vector<RegionMesh>> share_out_regions(std::span<const RegionBoundary> boundaries,
                                                  const Options& options,
                                                  const Callbacks& callbacks);

}  // namespace cover
