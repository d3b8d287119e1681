// The properties of a Mesh have names, so that OpenMesh's own tools find them.
#include <cover/mesh.hpp>
#include <cover/mesh_counts.hpp>

namespace cover {

Mesh::Mesh() : data_(std::make_unique<Data>()) {
  data_->tri.add_property(data_->region, "cover:region");
  data_->tri.add_property(data_->material, "cover:material");
  data_->tri.add_property(data_->input, "cover:input_id");
  data_->tri.add_property(data_->interface, "cover:interface");
  data_->tri.add_property(data_->marker, "cover:marker");
}
Mesh::Mesh(const Mesh& other)
    : data_(other.data_ ? std::make_unique<Data>(*other.data_) : nullptr) {}
Mesh::Mesh(Mesh&& other) noexcept = default;
Mesh& Mesh::operator=(Mesh other) noexcept {
  data_ = std::move(other.data_);
  return *this;
}
Mesh::~Mesh() = default;

const Mesh::Data& Mesh::empty() {
  static const Data none;
  return none;
}

std::size_t Mesh::vertices() const { return tri().n_vertices(); }
std::size_t Mesh::triangles() const { return tri().n_faces(); }

MeshCounts count_of(const Mesh& mesh) {
  return {mesh.vertices(), mesh.tri().n_edges(), mesh.triangles()};
}

}  // namespace cover
