// The properties of a Mesh have names, so that OpenMesh's own tools find them.
#include <cover/mesh.hpp>

namespace cover {

Mesh::Mesh() : tri_(std::make_unique<TriMesh>()) {
  tri_->add_property(keys_.region, "cover:region");
  tri_->add_property(keys_.material, "cover:material");
  tri_->add_property(keys_.input, "cover:input_id");
  tri_->add_property(keys_.interface, "cover:interface");
  tri_->add_property(keys_.marker, "cover:marker");
}

}  // namespace cover
