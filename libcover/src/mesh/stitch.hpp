// Puts the meshes of the regions together by vertex id: no search, no tolerance.
#pragma once

#include <span>

#include <cover/mesh_class.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>

#include "region/region_boundary.hpp"
#include "target/region_mesh.hpp"

namespace cover {

/// One conforming mesh of all regions.
///
/// REQUIRES: boundaries and meshes by RegionId - 1; every side of a boundary is an edge of its mesh
/// ENSURES:  the order of vertices, faces and edges depends on the arguments alone
/// Cost:     O(n)
Mesh stitch(const Pslg& pslg, const RegionTable& table, std::span<const RegionBoundary> boundaries,
            std::span<const RegionMesh> meshes);

}  // namespace cover
