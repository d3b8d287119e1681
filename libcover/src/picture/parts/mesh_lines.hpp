// Edges of a triangle soup by what lies on their two sides.
#pragma once

#include <vector>

#include <cover/picture.hpp>

namespace cover {

/// The edges of a mesh, each once.
struct MeshLines {
  std::vector<std::array<std::uint32_t, 2>> inner;    ///< between triangles of one region
  std::vector<std::array<std::uint32_t, 2>> borders;  ///< between regions, or with one triangle
};

/// REQUIRES: soup.region has a value per triangle, or none
/// Cost: O(n log n)
MeshLines lines_of(const TriangleSoup& soup);

}  // namespace cover
