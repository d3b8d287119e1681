// The properties of a Mesh have names, so that OpenMesh's own tools find them.
#include <cover/mesh.hpp>

namespace cover {

Mesh::Mesh() {
  tri.add_property(region_, "cover:region");
  tri.add_property(material_, "cover:material");
  tri.add_property(input_, "cover:input_id");
  tri.add_property(interface_, "cover:interface");
  tri.add_property(marker_, "cover:marker");
}

}  // namespace cover
