// Tested by tests/unit/io/read_mesh/read_mesh_test.cpp.
#include "io/read_mesh/mesh_collector.hpp"

#include <cstddef>
#include <limits>
#include <utility>

#include "geom/topology/corner.hpp"
#include "io/read_mesh/second_order.hpp"

namespace cover {

MeshFile MeshCollector::finish() {
  mesh.second_order = !midpoints_.empty();
  if (middles_.size() == mesh.soup.triangles.size()) {
    const auto at = [&](std::uint32_t p) { return mesh.soup.points[p]; };
    for (const auto& [a, b, c] : middles_) mesh.middles.push_back({at(a), at(b), at(c)});
  }
  if (!midpoints_.empty()) {
    std::vector<Point> named;
    for (const NamedPoint& point : mesh.named_points)
      named.push_back(mesh.soup.points[point.vertex.index()]);
    const std::vector<std::uint32_t> renumbered = drop_midpoints(midpoints_, mesh.soup);
    rename_points(named, renumbered);
    for (MeshLine& line : mesh.lines) {
      line.a = renumbered[line.a];
      line.b = renumbered[line.b];
    }
    for (PeriodicNodes& nodes : mesh.periodic) {
      for (auto& pair : nodes.vertices)
        for (std::uint32_t& v : pair) v = renumbered[v];
      for (auto& edge : nodes.edges)
        for (std::uint32_t& v : edge) v = renumbered[v];
    }
    for (PlaneField::Array& array : mesh.point_arrays)
      drop_values(renumbered, mesh.soup.points.size(), array.values);
  }
  return std::move(mesh);
}

void MeshCollector::name_points_apart(std::span<const NodeSet> sets) {
  constexpr std::size_t kNoSet = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> set_of(mesh.soup.points.size(), kNoSet);
  for (std::size_t s = 0; s < sets.size(); ++s) {
    if (sets[s].name.empty()) continue;
    for (const std::uint32_t v : sets[s].nodes)
      if (set_of[v] == kNoSet) set_of[v] = s;
  }
  std::vector<bool> is_line(sets.size(), false);
  for (const auto& t : mesh.soup.triangles) {
    for (const Corner k : kCorners) {
      const std::size_t s = set_of[t[k]];
      if (s != kNoSet && s == set_of[t[k.next()]]) is_line[s] = true;
    }
  }
  for (std::size_t s = 0; s < sets.size(); ++s) {
    for (const std::uint32_t v : sets[s].nodes) {
      if (is_line[s] || set_of[v] != s) continue;
      mesh.named_points.push_back({VertexId(v), sets[s].name});
      set_of[v] = kNoSet;
    }
  }
}

void MeshCollector::rename_points(const std::vector<Point>& places,
                                  const std::vector<std::uint32_t>& renumbered) {
  std::vector<NamedPoint> kept;
  for (std::size_t k = 0; k < places.size(); ++k) {
    NamedPoint& point = mesh.named_points[k];
    point.vertex = VertexId(renumbered[point.vertex.index()]);
    const std::size_t v = point.vertex.index();
    if (v < mesh.soup.points.size() && mesh.soup.points[v] == places[k])
      kept.push_back(std::move(point));
  }
  mesh.named_points = std::move(kept);
}

}  // namespace cover
