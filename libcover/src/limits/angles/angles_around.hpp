// What a mesh has around the vertices of its region: it tells which sides need not be asked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <cover/point.hpp>

#include "geom/topology/half_edges.hpp"

namespace cover {

/// The extreme angles of a covering mesh around each vertex of its region, as cotangents.
struct AnglesAround {
  std::vector<double> least_cot;   ///< of the largest angle of all triangles at the vertex
  std::vector<double> most_cot;    ///< of the smallest one
  std::vector<double> least_near;  ///< as least_cot, with the triangles at all neighbours

  /// Of `vertices`, which come first among `points`.
  ///
  /// REQUIRES: triangles counter-clockwise
  /// Cost:     O(points + triangles)
  static AnglesAround of(std::span<const Point> points, std::span<const IndexTriple> triangles,
                         std::size_t vertices);
};

}  // namespace cover
