// From bare triangles back to a triangulation.
#pragma once

#include <span>
#include <vector>

#include "cdt/triangulation.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {

/// Triangles as a RegionMesh has them, with their neighbours and all edges locked.
Triangulation with_neighbours(std::vector<Point> points, std::span<const IndexTriple> triangles);

}  // namespace cover
