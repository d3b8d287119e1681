#include "io/read_mesh/formats/msh_file.hpp"
#include "io/read_mesh/formats/msh_periodic.hpp"
#include "io/read_mesh/mesh_collector.hpp"
#include "io/read_mesh/mesh_formats.hpp"

namespace cover {

Result<MeshFile> parse_msh_mesh(std::string_view text, const std::string& source) {
  Result<MshFile> file = parse_msh_file(text, source);
  if (!file) return std::move(file).error();
  MeshCollector collector;
  MeshFile& mesh = collector.mesh;
  mesh.periodic = periodic_of_msh(text, *file);  // before its points are taken
  mesh.soup.points = std::move(file->points);
  mesh.point_arrays = std::move(file->point_arrays);
  mesh.has_periodic_points = file->has_periodic_points;
  mesh.parts = file->parts;
  for (const PlaneField::Array& array : file->element_arrays)
    mesh.arrays.push_back({array.name, {}});
  for (std::size_t e = 0; e < file->elements.size(); ++e) {
    const MshElement& element = file->elements[e];
    const auto nodes = file->nodes_of(element);
    if (element.dimension == 0) {
      const auto name = file->names.find({0, element.physical});
      if (name != file->names.end() && !name->second.empty())
        mesh.named_points.push_back({VertexId(nodes[0]), name->second});
    } else if (element.dimension == 1) {
      collector.add_line(nodes, element.physical);
    } else if (element.dimension == 2 && element.corners == 3) {
      collector.add_triangle(nodes);
      mesh.group.push_back(element.physical);
      for (std::size_t k = 0; k < mesh.arrays.size(); ++k)
        mesh.arrays[k].values.push_back(file->element_arrays[k].values[e]);
      if (file->has_entities) mesh.soup.region.push_back(element.entity);
    } else if (element.dimension == 2) {
      return Error{ErrorCode::unsupported_format, source + ": cells that are no triangles", {}, {}};
    }
  }
  for (const auto& [key, name] : file->names) {
    if (key.first == 1) mesh.line_names.emplace(key.second, name);
    if (key.first == 2) mesh.region_names.emplace(key.second, name);
  }
  return collector.finish();
}

}  // namespace cover
