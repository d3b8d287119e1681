// OpenMesh connectivity of triangles that are all known at once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/mesh.hpp>
#include <cover/point.hpp>

#include "base/team.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {

/// Makes a Mesh of points and triangles, which must outlive the builder.
class MeshBuilder {
 public:
  /// REQUIRES: vertex indices below points.size(); no directed edge occurs twice
  /// Cost:     O(n), 4 bytes per half-edge
  MeshBuilder(std::span<const Point> points, std::span<const IndexTriple> triangles,
              const Team& team = {});

  /// The mesh: vertices and faces in the order given, edges in the order in which faces have them.
  /// A vertex may have several fans of triangles with void between.
  ///
  /// REQUIRES: was not called before
  [[nodiscard]] Mesh build(const Team& team = {});

  /// The edge of half-edge `h` (numbered as in HalfEdges) in what build() has made.
  [[nodiscard]] TriMesh::EdgeHandle edge_of(std::uint32_t h) const {
    return TriMesh::s_edge_handle(halfedge(h));
  }

 private:
  struct Fan;

  [[nodiscard]] TriMesh::HalfedgeHandle halfedge(std::uint32_t h) const {
    return TriMesh::HalfedgeHandle(static_cast<int>(half_edge_[h]));
  }
  void count_edges(const Team& team);
  void number_half_edges(const Team& team);
  [[nodiscard]] std::vector<std::uint32_t> last_half_edges(const Team& team) const;
  void set_faces(std::size_t first, std::size_t last, TriMesh& tri) const;
  void set_boundary(const Team& team, TriMesh& tri) const;
  static Fan fan_from(const TriMesh& tri, TriMesh::HalfedgeHandle first);
  void sort_by_direction(std::span<Fan> fans) const;

  std::span<const Point> points_;
  std::span<const IndexTriple> triangles_;
  std::vector<std::uint32_t> half_edge_;     ///< OpenMesh's, by ours; at first the opposite
  std::vector<std::uint64_t> is_second_;     ///< a bit by half-edge: of its edge
  std::vector<std::uint32_t> edges_before_;  ///< by range of half-edges; at last all
  std::vector<std::uint32_t> boundary_;      ///< of OpenMesh's those whose opposite has no face
};

}  // namespace cover
