// The mesh of one region: method, fallbacks, layers, what is mended afterwards, limits.
#pragma once

#include <stop_token>

#include <cover/options.hpp>

#include "base/team.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// Meshes and measures one region, and proves limits of what it misses.
///
/// ENSURES: the mesh does not depend on the team
/// Throws: what the method throws
RegionMesh mesh_one_region(const RegionBoundary& boundary, const Options& options,
                           const std::stop_token& stop, const Team& team = {});

}  // namespace cover
