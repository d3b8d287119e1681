// The almond method for one region: the bound, then almonds where they are needed
// (docs/almond_method.md).
#pragma once

#include <stop_token>

#include <cover/options.hpp>

#include "base/team.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// Triangulates one region without putting a vertex on its boundary.
///
/// ENSURES: RegionMesh::report says which method was kept, what it reached, and every repair.
/// Threads: pure function of its arguments; whoever is in the team shares the work, and no byte
///          depends on it.
/// Ref:     mitchell_1993_covering
RegionMesh almond_region(const RegionBoundary& boundary, const Options& options,
                         std::stop_token stop, const Team& team = {});

}  // namespace cover
