// Tested by tests/unit/cuts/after_meshing/join_regions_test.cpp.
#include "cuts/hand_out_triangles.hpp"

namespace cover {

void hand_out_triangles(const JoinedMesh& mesh, std::span<const std::uint32_t> id,
                        std::span<const RegionBoundary> boundaries, std::size_t ids,
                        std::span<RegionMesh> meshes) {
  std::vector<std::vector<std::uint32_t>> of_region(meshes.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) of_region[mesh.region[t]].push_back(t);
  std::vector<std::uint32_t> on_boundary(ids), inside(mesh.points.size(), kNone);
  for (std::size_t r = 0; r < meshes.size(); ++r) {
    const RegionBoundary& boundary = boundaries[r];
    RegionMesh& part = meshes[r];
    for (std::uint32_t v = 0; v < boundary.vertices.size(); ++v)
      on_boundary[boundary.vertices[v].index()] = v;
    part.steiner.clear();
    part.triangles.clear();
    part.limits_are_old = true;
    const auto in_region = [&](std::uint32_t v) {
      if (id[v] != kNone) return on_boundary[id[v]];
      if (inside[v] == kNone) {
        inside[v] = static_cast<std::uint32_t>(boundary.points.size() + part.steiner.size());
        part.steiner.push_back(mesh.points[v]);
      }
      return inside[v];
    };
    for (const std::uint32_t t : of_region[r]) {
      IndexTriple triangle = mesh.triangles[t];
      for (std::uint32_t& v : triangle) v = in_region(v);
      part.triangles.push_back(triangle);
    }
  }
}

}  // namespace cover
