// See mesh_of_data_set.hpp.
#include "io/read_mesh/formats/mesh_of_data_set.hpp"

#include <algorithm>
#include <array>

#include "base/faults/errors.hpp"
#include "io/vtk_files/arrays/whole_number.hpp"

namespace cover {
namespace {

std::vector<std::size_t> cells_of_types(const DataSet& data, int first_order, int second_order) {
  std::vector<std::size_t> cells;
  for (std::size_t c = 0; c < data.cell_count(); ++c) {
    const int type = data.type(c);
    if (type == first_order || type == second_order) cells.push_back(c);
  }
  return cells;
}

std::vector<CellArray> cell_arrays(const DataSet& data, const std::vector<std::size_t>& cells) {
  std::vector<CellArray> arrays;
  for (const NumberArray& numbers : data.cell_arrays) {
    if (!numbers.is_one_per(data.cell_count())) continue;
    CellArray array{numbers.name, {}};
    array.values.reserve(cells.size());
    numbers.visit([&](auto values) {
      for (const std::size_t c : cells) array.values.push_back(static_cast<double>(values[c]));
    });
    arrays.push_back(std::move(array));
  }
  return arrays;
}

std::vector<PlaneField::Array> point_arrays(const DataSet& data) {
  std::vector<PlaneField::Array> arrays;
  for (const NumberArray& numbers : data.point_arrays) {
    if (!numbers.is_one_per(data.point_count())) continue;
    numbers.visit([&](auto values) {
      PlaneField::Array array{numbers.name, {}};
      array.values.reserve(values.size());
      for (std::size_t p = 0; p < values.size(); ++p)
        array.values.push_back(static_cast<double>(values[p]));
      arrays.push_back(std::move(array));
    });
  }
  return arrays;
}

std::vector<std::int64_t> integers(const std::vector<CellArray>& arrays,
                                   std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const auto found = std::find_if(arrays.begin(), arrays.end(),
                                    [&](const CellArray& array) { return array.name == name; });
    if (found == arrays.end()) continue;
    std::vector<std::int64_t> values;
    values.reserve(found->values.size());
    for (const double value : found->values) values.push_back(whole_number(value));
    return values;
  }
  return {};
}

}  // namespace

Result<MeshFile> mesh_of(const DataSet& data, const std::string& path,
                         const std::function<void(MeshCollector&)>& add) {
  const auto cells = cells_of_types(data, cell_type::kTriangle, cell_type::kQuadraticTriangle);
  if (cells.empty()) return wrong_file(path, "no triangles in it");
  if (Status plane = data.check_plane(); !plane) return in_file(path, std::move(plane).error());
  MeshCollector collector;
  MeshFile& mesh = collector.mesh;
  mesh.cut_vertices = data.cut_vertices;
  mesh.has_periodic_points = data.array_of_points("PeriodicNode") != nullptr;
  mesh.soup.points.reserve(data.point_count());
  for (std::size_t p = 0; p < data.point_count(); ++p) {
    const DataSet::Coordinates x = data.point(p);
    mesh.soup.points.push_back({x[0], x[1]});
  }
  std::array<std::uint32_t, 8> room{};
  mesh.soup.triangles.reserve(cells.size());
  for (const std::size_t c : cells) collector.add_triangle(data.nodes(c, room));
  if (const NumberArray* number = data.array_of_cells("LineID")) {
    const auto lines = cells_of_types(data, cell_type::kLine, cell_type::kQuadraticEdge);
    number->visit([&](auto numbers) {
      for (const std::size_t c : lines)
        collector.add_line(data.nodes(c, room), whole_number(static_cast<double>(numbers[c])));
    });
  }
  if (add) add(collector);
  mesh.arrays = cell_arrays(data, cells);
  mesh.point_arrays = point_arrays(data);
  mesh.soup.region = integers(mesh.arrays, {"RegionId"});
  mesh.soup.material =
      integers(mesh.arrays, {"material", "MaterialID", "mat_id", "gmsh:physical", "medit:ref"});
  return collector.finish();
}

}  // namespace cover
