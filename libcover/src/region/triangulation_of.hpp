// The triangulation from which all that is made of a region begins.
#pragma once

#include "base/team.hpp"
#include "cdt/triangulation.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// triangulate_region() of a region, with the triangles that are known of it: these cost or save
/// time and change nothing.
///
/// Errors: throws an InternalFault if the sides do not bound a region
/// Cost:   O(n log n); O(n) where the known triangles are the only ones that there can be
Triangulation triangulation_of(const RegionBoundary& boundary, const Team& team = {});

}  // namespace cover
