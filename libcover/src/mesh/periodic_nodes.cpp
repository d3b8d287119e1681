// Tested by tests/unit/pipeline/periodic_test.cpp.
#include "mesh/periodic_nodes.hpp"

#include <algorithm>
#include <utility>

#include <cover/mesh.hpp>

#include "base/containers/order.hpp"
#include "base/containers/union_find.hpp"
#include "base/none.hpp"

namespace cover {
namespace {

/// The vertex of the mesh that each point is.
std::vector<std::uint32_t> vertices_of_points(const Pslg& pslg, const Mesh& mesh) {
  std::vector<std::uint32_t> vertex(pslg.points.size(), kNone);
  for (const auto v : mesh.tri().vertices()) {
    const long point = mesh.input_id(v);
    if (point >= 0) vertex[static_cast<std::size_t>(point)] = static_cast<std::uint32_t>(v.idx());
  }
  return vertex;
}

}  // namespace

std::vector<PeriodicNodes> periodic_nodes(const Pslg& pslg, const std::vector<PeriodicRule>& rules,
                                          const Mesh& mesh) {
  std::vector<PeriodicNodes> all;
  if (rules.empty()) return all;
  for (std::size_t r = 0; r < rules.size(); ++r)
    all.push_back({rules[r], pslg.isometries[r], {}, {}});
  const std::vector<std::uint32_t> vertex = vertices_of_points(pslg, mesh);
  for (const SegmentPair& pair : pslg.periodic) {
    const Segment& from = pslg.segments[pair.from.index()];
    const Segment& to = pslg.segments[pair.to.index()];
    std::array<std::uint32_t, 4> edge{vertex[from.a.index()], vertex[from.b.index()],
                                      vertex[to.a.index()], vertex[to.b.index()]};
    if (pair.turned) std::swap(edge[2], edge[3]);
    if (std::find(edge.begin(), edge.end(), kNone) != edge.end()) continue;
    PeriodicNodes& nodes = all[pair.rule];
    nodes.edges.push_back(edge);
    nodes.vertices.push_back({edge[0], edge[2]});
    nodes.vertices.push_back({edge[1], edge[3]});
  }
  for (PeriodicNodes& nodes : all) {
    std::sort(nodes.edges.begin(), nodes.edges.end());
    sort_unique(nodes.vertices);
  }
  return all;
}

std::vector<std::uint32_t> periodic_classes(const std::vector<PeriodicNodes>& periodic,
                                            std::size_t vertices) {
  UnionFind sets(vertices);
  for (const PeriodicNodes& nodes : periodic) {
    for (const auto& [u, v] : nodes.vertices) sets.unite(u, v);
  }
  std::vector<std::uint32_t> smallest(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) smallest[v] = sets.find(v);
  return smallest;
}

}  // namespace cover
