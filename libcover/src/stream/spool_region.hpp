// A region on its way into a spool.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/ids.hpp>

#include "io/write_mesh/mesh_spool.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// Adds a mesh to a spool, with the angles of its triangles. `vertices` are the numbers that the
/// vertices of the boundary have in the whole mesh. Returns, by side of the boundary, the half-edge
/// on it; kNone: there is none.
///
/// Threads: any, each with regions of its own
std::vector<std::uint32_t> spool_region(std::size_t region, const RegionBoundary& boundary,
                                        std::vector<VertexId> vertices, RegionMesh mesh,
                                        MeshSpool& spool);

}  // namespace cover
