// A mesh of all regions, taken apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/point.hpp>

#include "cdt/triangulation.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// One mesh of all regions.
struct JoinedMesh {
  std::span<const Point> points;
  std::span<const std::uint32_t> id;  ///< by point: its VertexId; kNone inside a region
  std::span<const IndexTriple> triangles;
  std::span<const std::uint32_t> region;  ///< of each triangle, an index into the boundaries
};

/// Gives each region its triangles, and the points inside of it in the order in which they first
/// come.
///
/// REQUIRES: each region of `meshes` has its boundary; ids are below `ids`
/// ENSURES:  reports are as before, with limits that are old
/// Cost:     O(n)
void hand_out_triangles(const JoinedMesh& mesh, std::span<const RegionBoundary> boundaries,
                        std::size_t ids, std::span<RegionMesh> meshes);

}  // namespace cover
