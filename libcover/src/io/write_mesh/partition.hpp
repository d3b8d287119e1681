// A mesh divided among processes that are to start with a part of it each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cover/error.hpp>
#include <cover/mesh_view.hpp>

namespace cover {

/// What one process gets.
struct MeshPart {
  std::vector<std::size_t> own;     ///< triangles, in the order of the mesh
  std::vector<std::size_t> ghosts;  ///< those of others that share a vertex with them
};

/// A mesh in parts.
struct Partition {
  std::vector<std::uint32_t> owner;         ///< part of each triangle
  std::vector<std::uint32_t> vertex_owner;  ///< the lowest part of each vertex's triangles
  std::vector<MeshPart> parts;
};

/// Divides the triangles into `parts` of about equal size, regions along a Hilbert curve and the
/// triangles of a region likewise. A region is in one part unless it has more than an eighth of a
/// part's triangles; so parts differ from the mean by an eighth of it at most, where regions allow.
///
/// REQUIRES: parts > 0
/// ENSURES:  the same for every run; a part may be empty where there are few triangles
/// Cost:     O(n log n)
Partition partition_of(const MeshView& view, std::uint32_t parts);

/// Why a mesh with periodic sides is not written in the parts of a .msh.
Error periodic_in_parts(const std::string& path);

}  // namespace cover
