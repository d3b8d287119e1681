// The triangles of one region, and what is to be said about them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/point.hpp>
#include <cover/report.hpp>

#include "region/region_boundary.hpp"

namespace cover {

/// Triangles over the points of a RegionBoundary (indices below its size) and Steiner vertices
/// (indices from there on).
struct RegionMesh {
  std::vector<Point> steiner;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t layer_triangles = 0;  ///< the first so many are those of layers, but for flips
  std::size_t layer_vertices = 0;   ///< the first so many Steiner vertices
  RegionReport report;
  bool limits_are_old = false;  ///< triangles have changed since RegionReport::limits were proven
};

/// The vertices of a region's mesh: those of the boundary, then the Steiner vertices.
inline std::vector<Point> all_points(const RegionBoundary& boundary, const RegionMesh& mesh) {
  std::vector<Point> points;
  points.reserve(boundary.points.size() + mesh.steiner.size());
  points.insert(points.end(), boundary.points.begin(), boundary.points.end());
  points.insert(points.end(), mesh.steiner.begin(), mesh.steiner.end());
  return points;
}

}  // namespace cover
