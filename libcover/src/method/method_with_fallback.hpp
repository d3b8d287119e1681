// The method asked for, or another one where that breaks the mesh or the bound.
#pragma once

#include <stop_token>

#include <cover/options.hpp>

#include "base/team.hpp"
#include "quality/quality_region.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// The method asked for; where that misses the bound, the other one if it is better; where both
/// break the mesh, the constrained Delaunay triangulation. A note tells what was not used.
///
/// ENSURES: the mesh fills the region, and is measured, unless the run is to stop; the proof is of
///          the method asked for
/// Throws:  what the methods throw; InternalFault if nothing fills the region
ProvenMesh method_with_fallback(const RegionBoundary& boundary, const Options& options,
                                const std::stop_token& stop, const Team& team);

}  // namespace cover
