// Puts the meshes of the regions together by vertex id: no search, no tolerance.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/mesh_class.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>

#include "base/team.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// The vertex of a mesh that each point of the PSLG is, kNone where no region has it.
std::vector<std::uint32_t> input_vertices(const Pslg& pslg,
                                          std::span<const RegionBoundary> boundaries);

/// One conforming mesh of all regions.
///
/// REQUIRES: boundaries and meshes by RegionId - 1; every side of a boundary is an edge of its mesh
/// ENSURES:  `meshes` have no vertices and triangles any more; the order of vertices, faces and
///           edges depends on the arguments alone
/// Cost:     O(n)
Mesh stitch(const Pslg& pslg, const RegionTable& table, std::vector<RegionBoundary> boundaries,
            std::span<RegionMesh> meshes, const Team& team = {});

}  // namespace cover
