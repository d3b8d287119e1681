// OpenMesh connectivity of triangles that are all known at once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/mesh.hpp>
#include <cover/point.hpp>

#include "geom/topology/half_edges.hpp"

namespace cover {

/// Makes a Mesh of points and triangles, which must outlive the builder.
class MeshBuilder {
 public:
  /// REQUIRES: vertex indices below points.size()
  /// Cost:     O(n log d) for vertices of degree d
  MeshBuilder(std::span<const Point> points, std::span<const IndexTriple> triangles);

  /// True if no directed edge occurs twice: else the triangles overlap and are no mesh.
  [[nodiscard]] bool is_mesh() const { return pairs_.all_different(); }

  /// The mesh: vertices and faces in the order given, edges in the order in which faces have them.
  /// A vertex may have several fans of triangles with void between.
  ///
  /// REQUIRES: is_mesh()
  [[nodiscard]] Mesh build() const;

  /// The edge between two vertices in what build() makes, invalid if there is none.
  [[nodiscard]] TriMesh::EdgeHandle edge_between(std::uint32_t a, std::uint32_t b) const;

 private:
  struct Fan;

  void number_half_edges();
  void set_points(TriMesh& tri) const;
  void set_faces(TriMesh& tri) const;
  void set_boundary(TriMesh& tri) const;
  [[nodiscard]] Fan fan_from(std::uint32_t first) const;
  void sort_by_direction(std::span<Fan> fans) const;

  std::span<const Point> points_;
  std::span<const IndexTriple> triangles_;
  HalfEdges pairs_;
  std::vector<TriMesh::HalfedgeHandle> half_edge_;  ///< OpenMesh's, by ours
  std::vector<std::uint32_t> boundary_;             ///< half-edges without a twin
  std::size_t edges_ = 0;
};

}  // namespace cover
