// What a test of readers compares.
#pragma once

#include <map>
#include <string>
#include <utility>

#include <cover/output.hpp>

namespace cover::testing {

/// Interface and marker of every edge that has one, by its ends.
inline std::map<std::pair<int, int>, std::pair<std::string, int>> edges_of(const Output& output) {
  std::map<std::pair<int, int>, std::pair<std::string, int>> edges;
  const TriMesh& tri = output.mesh.tri();
  for (const auto e : tri.edges()) {
    const InterfaceId id = output.mesh.interface(e);
    if (id == kNoInterface) continue;
    const auto h = tri.halfedge_handle(e, 0);
    const int a = tri.from_vertex_handle(h).idx(), b = tri.to_vertex_handle(h).idx();
    edges[std::minmax(a, b)] = {output.table.interface(id).name, output.mesh.marker(e)};
  }
  return edges;
}

}  // namespace cover::testing
