// Tested by tests/unit/stream/stream_mesh_test.cpp.
#include "stream/spool_region.hpp"

#include <array>
#include <utility>

#include "geom/topology/half_edges.hpp"
#include "io/write_mesh/vtk_formats/vtu_parts.hpp"

namespace cover {
namespace {

std::vector<std::uint32_t> half_edges_of_sides(const RegionBoundary& boundary, std::size_t points,
                                               std::span<const IndexTriple> triangles) {
  const HalfEdges edges(points, triangles);
  std::vector<std::uint32_t> found;
  found.reserve(boundary.sides.size());
  for (const auto& [a, b] : boundary.sides) found.push_back(edges.find(a, b));
  static_assert(kNone == kNone);
  return found;
}

}  // namespace

std::vector<std::uint32_t> spool_region(std::size_t region, const RegionBoundary& boundary,
                                        std::vector<VertexId> vertices, RegionMesh mesh,
                                        MeshSpool& spool) {
  const std::vector<Point> points = all_points(boundary, mesh);
  std::vector<std::uint32_t> on_sides =
      half_edges_of_sides(boundary, points.size(), mesh.triangles);
  std::vector<std::array<double, 2>> angles;
  angles.reserve(mesh.triangles.size());
  const auto size = static_cast<std::uint32_t>(vertices.size());
  const auto inputs = static_cast<std::uint32_t>(spool.input_vertices());
  for (IndexTriple& t : mesh.triangles) {
    angles.push_back(extreme_degrees(points[t[0]], points[t[1]], points[t[2]]));
    for (std::uint32_t& v : t) v = v < size ? vertices[v].value() : inputs + (v - size);
  }
  spool.add(region, mesh.steiner, mesh.triangles, angles);
  return on_sides;
}

}  // namespace cover
