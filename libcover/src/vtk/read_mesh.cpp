// A table says which reader each extension has. For VTK's formats VTK's own readers do the work,
// and triangles, lines and cell arrays are taken out of their grid. Tested by
// tests/unit/vtk/read_output_test.cpp.
#include <cover/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/ranges.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "base/errors.hpp"
#include "io/read_mesh/mesh_collector.hpp"
#include "io/read_mesh/mesh_formats.hpp"
#include "io/text/text.hpp"
#include "vtk/cell_values.hpp"
#include "vtk/read_quietly.hpp"
#include "vtk/read_xdmf.hpp"

namespace cover {
namespace {

std::vector<vtkIdType> cells_of_types(vtkUnstructuredGrid& grid, int first_order,
                                      int second_order) {
  std::vector<vtkIdType> cells;
  for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
    const int type = grid.GetCellType(c);
    if (type == first_order || type == second_order) cells.push_back(c);
  }
  return cells;
}

std::vector<CellArray> cell_arrays(vtkUnstructuredGrid& grid, const std::vector<vtkIdType>& cells) {
  std::vector<CellArray> arrays;
  for (int i = 0; i < grid.GetCellData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* data = grid.GetCellData()->GetArray(i);
    if (!is_one_per_cell(data, grid) || data->GetName() == nullptr) continue;
    CellArray array{data->GetName(), {}};
    array.values.reserve(cells.size());
    for (const vtkIdType c : cells) array.values.push_back(data->GetComponent(c, 0));
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

/// The nodes of cells, one after the other; false if one of them is out of range, or a cell has
/// fewer than `least`.
template <class Add>
bool each_cell(vtkUnstructuredGrid& grid, const std::vector<vtkIdType>& cells, vtkIdType least,
               Add add) {
  vtkNew<vtkIdList> ids;
  std::vector<std::uint32_t> nodes;
  for (const vtkIdType c : cells) {
    grid.GetCellPoints(c, ids);
    if (ids->GetNumberOfIds() < least) return false;
    nodes.clear();
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
      if (ids->GetId(i) < 0 || ids->GetId(i) >= grid.GetNumberOfPoints()) return false;
      nodes.push_back(static_cast<std::uint32_t>(ids->GetId(i)));
    }
    add(c, nodes);
  }
  return true;
}

Result<MeshFile> mesh_of(vtkUnstructuredGrid* grid, const std::string& path) {
  if (grid == nullptr) return wrong_file(path, "not a valid VTK file");
  const auto cells = cells_of_types(*grid, VTK_TRIANGLE, VTK_QUADRATIC_TRIANGLE);
  if (cells.empty()) return wrong_file(path, "no triangles in it");
  MeshCollector collector;
  MeshFile& mesh = collector.mesh;
  mesh.soup.points.reserve(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p) {
    std::array<double, 3> x{};
    grid->GetPoint(p, x.data());
    mesh.soup.points.push_back({x[0], x[1]});
  }
  bool in_range = each_cell(*grid, cells, 3, [&](vtkIdType, std::span<const std::uint32_t> nodes) {
    collector.add_triangle(nodes);
  });
  vtkDataArray* number = grid->GetCellData()->GetArray("LineID");
  if (is_one_per_cell(number, *grid)) {
    const auto lines = cells_of_types(*grid, VTK_LINE, VTK_QUADRATIC_EDGE);
    in_range &= each_cell(*grid, lines, 2, [&](vtkIdType c, std::span<const std::uint32_t> nodes) {
      collector.add_line(nodes, whole_number(number->GetTuple1(c)));
    });
  }
  if (!in_range) return wrong_file(path, "a cell has a node that is not there");
  mesh.arrays = cell_arrays(*grid, cells);
  mesh.soup.region = integers(mesh.arrays, {"RegionId"});
  mesh.soup.material =
      integers(mesh.arrays, {"material", "MaterialID", "mat_id", "gmsh:physical", "medit:ref"});
  return collector.finish();
}

Result<MeshFile> read_vtu(const std::string& path) {
  return mesh_of(read_quietly<vtkUnstructuredGrid, vtkXMLUnstructuredGridReader>(path), path);
}

Result<MeshFile> read_legacy_vtk(const std::string& path) {
  return mesh_of(read_quietly<vtkUnstructuredGrid, vtkUnstructuredGridReader>(path), path);
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
    Format{".vtu", read_vtu},
    Format{".vtk", read_legacy_vtk},
    Format{".msh", read_text<parse_msh_mesh>},
    Format{".xdmf", read_xdmf},
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
  const std::string extension = std::filesystem::path(path).extension();
  const auto* const format = std::find_if(
      kFormats.begin(), kFormats.end(), [&](const Format& f) { return f.extension == extension; });
  if (format == kFormats.end())
    return Error{ErrorCode::unsupported_format,
                 fmt::format("cannot read '{}' as a mesh{}: possible are {}", path,
                             reason(extension), fmt::join(mesh_formats(), ", ")),
                 {},
                 {}};
  if (!std::filesystem::is_regular_file(path))
    return Error{ErrorCode::cannot_open, fmt::format("cannot open '{}'", path), {}, {}};
  Result<MeshFile> mesh = format->read(path);
  if (mesh && mesh->soup.triangles.empty()) return wrong_file(path, "no triangles in it");
  return mesh;
}

}  // namespace cover
