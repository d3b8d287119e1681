// How much there is in a mesh.
#pragma once

#include <cstddef>

#include <cover/mesh_class.hpp>

namespace cover {

/// How many there are of each.
struct MeshCounts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t triangles = 0;
};

MeshCounts count_of(const Mesh& mesh);

}  // namespace cover
