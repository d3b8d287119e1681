// The result: one OpenMesh structure over all regions.
#pragma once

#include <memory>

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
///
/// OpenMesh's meshes cannot be moved, so one is held by pointer: moving a Mesh is cheap. A Mesh
/// that was moved from may only be assigned to or destroyed.
class Mesh {
 public:
  Mesh();
  Mesh(const Mesh& other) : tri_(std::make_unique<TriMesh>(*other.tri_)), keys_(other.keys_) {}
  Mesh(Mesh&& other) noexcept = default;
  Mesh& operator=(Mesh other) noexcept {
    tri_ = std::move(other.tri_);
    keys_ = other.keys_;
    return *this;
  }
  ~Mesh() = default;

  /// Connectivity and coordinates.
  [[nodiscard]] const TriMesh& tri() const { return *tri_; }
  [[nodiscard]] TriMesh& tri() { return *tri_; }

  /// The region of a face.
  [[nodiscard]] RegionId region(TriMesh::FaceHandle f) const {
    return tri_->property(keys_.region, f);
  }
  /// The material of a face; positive.
  [[nodiscard]] int material(TriMesh::FaceHandle f) const {
    return tri_->property(keys_.material, f);
  }
  /// The PSLG point that a vertex is, or -1 for a Steiner vertex.
  [[nodiscard]] long input_id(TriMesh::VertexHandle v) const {
    return tri_->property(keys_.input, v);
  }
  /// The interface that an edge lies on, kNoInterface for inner edges.
  [[nodiscard]] InterfaceId interface(TriMesh::EdgeHandle e) const {
    return tri_->property(keys_.interface, e);
  }
  /// The boundary marker of an edge, 0 if none.
  [[nodiscard]] int marker(TriMesh::EdgeHandle e) const { return tri_->property(keys_.marker, e); }

  void set_region(TriMesh::FaceHandle f, RegionId r) { tri_->property(keys_.region, f) = r; }
  void set_material(TriMesh::FaceHandle f, int m) { tri_->property(keys_.material, f) = m; }
  void set_input_id(TriMesh::VertexHandle v, long id) { tri_->property(keys_.input, v) = id; }
  void set_interface(TriMesh::EdgeHandle e, InterfaceId i) {
    tri_->property(keys_.interface, e) = i;
  }
  void set_marker(TriMesh::EdgeHandle e, int m) { tri_->property(keys_.marker, e) = m; }

 private:
  struct Keys {
    OpenMesh::FPropHandleT<RegionId> region;
    OpenMesh::FPropHandleT<int> material;
    OpenMesh::VPropHandleT<long> input;
    OpenMesh::EPropHandleT<InterfaceId> interface;
    OpenMesh::EPropHandleT<int> marker;
  };

  std::unique_ptr<TriMesh> tri_;
  Keys keys_;
};

}  // namespace cover
