// A joined mesh, taken apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mend/joined_mesh.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// Gives each region its triangles, and the points inside of it in the order in which they first
/// come. `id`, by point: its VertexId; kNone inside a region.
///
/// REQUIRES: each region of `meshes` has its boundary; ids are below `ids`
/// ENSURES:  reports are as before, with limits that are old
/// Cost:     O(n)
void hand_out_triangles(const JoinedMesh& mesh, std::span<const std::uint32_t> id,
                        std::span<const RegionBoundary> boundaries, std::size_t ids,
                        std::span<RegionMesh> meshes);

}  // namespace cover
