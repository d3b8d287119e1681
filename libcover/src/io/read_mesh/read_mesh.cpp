// A table says which parser each extension has; of VTK's data sets, triangles, lines and cell
// arrays are taken. Tested by tests/unit/vtk/read_output_test.cpp.
#include <cover/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <span>

#include <fmt/ranges.h>

#include "base/errors.hpp"
#include "base/out_of_memory.hpp"
#include "io/read_mesh/mesh_collector.hpp"
#include "io/read_mesh/mesh_formats.hpp"
#include "io/text/text.hpp"
#include "io/vtk_files/read_data_set.hpp"
#include "io/vtk_files/whole_number.hpp"

namespace cover {
namespace {

using Nodes = std::span<const std::uint32_t>;

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

Result<MeshFile> mesh_of(const DataSet& data, const std::string& path) {
  const auto cells = cells_of_types(data, cell_type::kTriangle, cell_type::kQuadraticTriangle);
  if (cells.empty()) return wrong_file(path, "no triangles in it");
  MeshCollector collector;
  MeshFile& mesh = collector.mesh;
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
  mesh.arrays = cell_arrays(data, cells);
  mesh.soup.region = integers(mesh.arrays, {"RegionId"});
  mesh.soup.material =
      integers(mesh.arrays, {"material", "MaterialID", "mat_id", "gmsh:physical", "medit:ref"});
  return collector.finish();
}

Result<MeshFile> read_vtk(const std::string& path) {
  const Result<DataSetFile> file = read_data_set(path);
  return file ? mesh_of(file->data, path) : file.error();
}

/// A reader of a text as one of a file.
template <Result<MeshFile> (*parse)(std::string_view, const std::string&)>
Result<MeshFile> read_text(const std::string& path) {
  const Result<std::string> text = read_file(path);
  return text ? parse(*text, path) : text.error();
}

struct Format {
  const char* extension;
  Result<MeshFile> (*read)(const std::string& path);
};

constexpr std::array kFormats{
    Format{".vtu", read_vtk},
    Format{".vtk", read_vtk},
    Format{".msh", read_text<parse_msh_mesh>},
    Format{".xdmf", read_text<parse_xdmf>},
    Format{".mesh", read_text<parse_medit>},
    Format{".inp", read_text<parse_inp>},
    Format{".ele", read_triangle},
};

/// Why meshes in a format that write_mesh() knows cannot be read.
std::string_view reason(std::string_view extension) {
  if (extension == ".obj" || extension == ".off" || extension == ".ply")
    return ", which keeps no regions that could be read back";
  if (extension == ".json")
    return ", which is a geometry or names, but no mesh: give the mesh itself";
  return "";
}

}  // namespace

std::vector<std::string> mesh_formats() {
  std::vector<std::string> extensions;
  for (const Format& format : kFormats) extensions.emplace_back(format.extension);
  return extensions;
}

Result<MeshFile> read_mesh(const std::string& path) {
  return memory_as_value(path, [&]() -> Result<MeshFile> {
    const std::string extension = extension_of(path);
    const auto* const format = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) {
      return f.extension == extension;
    });
    if (format == kFormats.end())
      return Error{ErrorCode::unsupported_format,
                   fmt::format("cannot read '{}' as a mesh{}: possible are {}", path,
                               reason(extension), fmt::join(mesh_formats(), ", ")),
                   {},
                   {}};
    Result<MeshFile> mesh = format->read(path);
    if (mesh && mesh->soup.triangles.empty()) return wrong_file(path, "no triangles in it");
    return mesh;
  });
}

}  // namespace cover
