// Sizes that a region's mesh does not have, for the report.
#pragma once

#include <optional>

#include <cover/report.hpp>

#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// A warning where sizes that were asked for did not count, or count for little: the mesh is one of
/// the almond method, which knows none; or edges at vertices with a size of their own are on
/// average several times as long. Vertices at ends of longer sides are left out: that these stay
/// whole is told before meshing (warn_of_sizes).
///
/// REQUIRES: sizes were asked for; RegionReport::method says how the mesh came about
/// Cost:     O(n log n)
std::optional<Note> missed_sizes(const RegionBoundary& boundary, const RegionMesh& mesh);

}  // namespace cover
