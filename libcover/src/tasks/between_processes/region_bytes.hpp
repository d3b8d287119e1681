// Regions, meshes and options as bytes, for other processes of the same program.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/options.hpp>
#include <cover/share_out.hpp>

#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// What is told of a mesh that stays where it was made.
struct KeptMesh {
  RegionReport report;
  std::uint32_t steiner = 0;  ///< how many
  std::uint32_t triangles = 0;
  std::vector<std::uint32_t> half_edges;  ///< by side of the boundary: that on it; kNone: none
};

Bytes to_bytes(const RegionBoundary& boundary);
Bytes to_bytes(const Result<RegionMesh>& mesh);
Bytes to_bytes(const Result<KeptMesh>& mesh);
/// All but the size field, which has its name alone.
Bytes to_bytes(const Options& options);

/// Errors of all: internal if `bytes` are not those of the function above.
Result<RegionBoundary> boundary_of_bytes(std::span<const std::byte> bytes);
/// Errors: the one that was sent, too; out_of_memory where there are no bytes
Result<RegionMesh> mesh_of_bytes(std::span<const std::byte> bytes);
Result<KeptMesh> kept_of_bytes(std::span<const std::byte> bytes);

}  // namespace cover
