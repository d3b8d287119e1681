// The result: one OpenMesh structure over all regions.
#pragma once

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <cover/ids.hpp>

namespace cover {

/// Double coordinates; no normals, colours or status.
struct MeshTraits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::None);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
};

using TriMesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

/// A triangle mesh with regions. Vertices come in this order: the points of the PSLG that lie in
/// or on a region, by VertexId; then Steiner vertices by region. Faces come by region. z is 0.
class Mesh {
 public:
  Mesh();

  TriMesh tri;

  /// The region of a face.
  [[nodiscard]] RegionId region(TriMesh::FaceHandle f) const { return tri.property(region_, f); }
  /// The material of a face; positive.
  [[nodiscard]] int material(TriMesh::FaceHandle f) const { return tri.property(material_, f); }
  /// The PSLG point that a vertex is, or -1 for a Steiner vertex.
  [[nodiscard]] long input_id(TriMesh::VertexHandle v) const { return tri.property(input_, v); }
  /// The interface that an edge lies on, kNoInterface for inner edges.
  [[nodiscard]] InterfaceId interface(TriMesh::EdgeHandle e) const {
    return tri.property(interface_, e);
  }
  /// The boundary marker of an edge, 0 if none.
  [[nodiscard]] int marker(TriMesh::EdgeHandle e) const { return tri.property(marker_, e); }

  void set_region(TriMesh::FaceHandle f, RegionId r) { tri.property(region_, f) = r; }
  void set_material(TriMesh::FaceHandle f, int m) { tri.property(material_, f) = m; }
  void set_input_id(TriMesh::VertexHandle v, long id) { tri.property(input_, v) = id; }
  void set_interface(TriMesh::EdgeHandle e, InterfaceId i) { tri.property(interface_, e) = i; }
  void set_marker(TriMesh::EdgeHandle e, int m) { tri.property(marker_, e) = m; }

 private:
  OpenMesh::FPropHandleT<RegionId> region_;
  OpenMesh::FPropHandleT<int> material_;
  OpenMesh::VPropHandleT<long> input_;
  OpenMesh::EPropHandleT<InterfaceId> interface_;
  OpenMesh::EPropHandleT<int> marker_;
};

}  // namespace cover
