// The result: one OpenMesh structure over all regions.
#pragma once

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <cover/mesh_class.hpp>

namespace cover {

/// Double coordinates; no normals, colours or status.
struct MeshTraits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::None);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
};

/// What a Mesh holds: the structure, and where its properties are.
struct Mesh::Data {
  TriMesh tri;
  OpenMesh::FPropHandleT<RegionId> region;
  OpenMesh::FPropHandleT<int> material;
  OpenMesh::VPropHandleT<long> input;
  OpenMesh::EPropHandleT<InterfaceId> interface;
  OpenMesh::EPropHandleT<int> marker;
};

inline const TriMesh& Mesh::tri() const { return data_ ? data_->tri : empty().tri; }
inline TriMesh& Mesh::tri() {
  if (!data_) *this = Mesh();
  return data_->tri;
}

inline RegionId Mesh::region(OpenMesh::FaceHandle f) const {
  return data_->tri.property(data_->region, f);
}
inline int Mesh::material(OpenMesh::FaceHandle f) const {
  return data_->tri.property(data_->material, f);
}
inline long Mesh::input_id(OpenMesh::VertexHandle v) const {
  return data_->tri.property(data_->input, v);
}
inline InterfaceId Mesh::interface(OpenMesh::EdgeHandle e) const {
  return data_->tri.property(data_->interface, e);
}
inline int Mesh::marker(OpenMesh::EdgeHandle e) const {
  return data_->tri.property(data_->marker, e);
}

inline void Mesh::set_region(OpenMesh::FaceHandle f, RegionId r) {
  data_->tri.property(data_->region, f) = r;
}
inline void Mesh::set_material(OpenMesh::FaceHandle f, int m) {
  data_->tri.property(data_->material, f) = m;
}
inline void Mesh::set_input_id(OpenMesh::VertexHandle v, long id) {
  data_->tri.property(data_->input, v) = id;
}
inline void Mesh::set_interface(OpenMesh::EdgeHandle e, InterfaceId i) {
  data_->tri.property(data_->interface, e) = i;
}
inline void Mesh::set_marker(OpenMesh::EdgeHandle e, int m) {
  data_->tri.property(data_->marker, e) = m;
}

}  // namespace cover
