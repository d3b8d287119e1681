// The triangles of one region, and what is to be said about them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/point.hpp>
#include <cover/report.hpp>

namespace cover {

/// Triangles over the points of a RegionBoundary (indices below its size) and Steiner vertices
/// (indices from there on).
struct RegionMesh {
  std::vector<Point> steiner;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t layer_triangles = 0;  ///< the first so many are those of layers, but for flips
  std::size_t layer_vertices = 0;   ///< the first so many Steiner vertices
  RegionReport report;
};

}  // namespace cover
