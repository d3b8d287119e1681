// The class Mesh without OpenMesh, which takes two seconds to compile: for files that only pass
// meshes on. Whoever looks into one includes <cover/mesh.hpp>.
#pragma once

#include <cstddef>
#include <memory>

#include <cover/ids.hpp>

namespace OpenMesh {  // NOLINT(readability-identifier-naming)
template <class Traits>
class TriMesh_ArrayKernelT;
struct VertexHandle;
struct EdgeHandle;
struct FaceHandle;
}  // namespace OpenMesh

namespace cover {

struct MeshTraits;
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

/// A triangle mesh with regions. Vertices come in this order: the points of the PSLG that lie in
/// or on a region, by VertexId; then Steiner vertices by region. Faces come by region. z is 0.
///
/// OpenMesh's meshes cannot be moved, so one is held by pointer: moving a Mesh is cheap. A Mesh
/// that was moved from is empty, and may be used as any other.
class Mesh {
 public:
  Mesh();
  Mesh(const Mesh& other);
  Mesh(Mesh&& other) noexcept;
  Mesh& operator=(Mesh other) noexcept;
  ~Mesh();

  /// How many there are.
  [[nodiscard]] std::size_t vertices() const;
  [[nodiscard]] std::size_t triangles() const;

  /// Connectivity and coordinates.
  [[nodiscard]] const TriMesh& tri() const;
  [[nodiscard]] TriMesh& tri();

  /// The region of a face.
  [[nodiscard]] RegionId region(OpenMesh::FaceHandle f) const;
  /// The material of a face; positive.
  [[nodiscard]] int material(OpenMesh::FaceHandle f) const;
  /// The PSLG point that a vertex is, or -1 for a Steiner vertex.
  [[nodiscard]] long input_id(OpenMesh::VertexHandle v) const;
  /// The interface that an edge lies on, kNoInterface for inner edges.
  [[nodiscard]] InterfaceId interface(OpenMesh::EdgeHandle e) const;
  /// The boundary marker of an edge, 0 if none.
  [[nodiscard]] int marker(OpenMesh::EdgeHandle e) const;

  void set_region(OpenMesh::FaceHandle f, RegionId r);
  void set_material(OpenMesh::FaceHandle f, int m);
  void set_input_id(OpenMesh::VertexHandle v, long id);
  void set_interface(OpenMesh::EdgeHandle e, InterfaceId i);
  void set_marker(OpenMesh::EdgeHandle e, int m);

 private:
  struct Data;
  /// That of all meshes that were moved from.
  static const Data& empty();

  std::unique_ptr<Data> data_;  ///< null: moved from
};

}  // namespace cover
