// VTK's own readers do the work; this file takes triangles and cell arrays out of their grid.
// Tests: tests/cli/cli_test.py reads what other parts wrote.
#include <cover/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "io/second_order.hpp"
#include "vtk/read_quietly.hpp"

namespace cover {
namespace {

std::vector<vtkIdType> triangle_cells(vtkUnstructuredGrid& grid) {
  std::vector<vtkIdType> cells;
  for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
    const int type = grid.GetCellType(c);
    if (type == VTK_TRIANGLE || type == VTK_QUADRATIC_TRIANGLE) cells.push_back(c);
  }
  return cells;
}

std::vector<CellArray> cell_arrays(vtkUnstructuredGrid& grid, const std::vector<vtkIdType>& cells) {
  std::vector<CellArray> arrays;
  for (int i = 0; i < grid.GetCellData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* data = grid.GetCellData()->GetArray(i);
    if (data == nullptr || data->GetNumberOfComponents() != 1 || data->GetName() == nullptr)
      continue;
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
    return {found->values.begin(), found->values.end()};
  }
  return {};
}

}  // namespace

Result<MeshFile> read_mesh(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) {
    return Error{ErrorCode::cannot_open, fmt::format("cannot open '{}'", path), {}, {}};
  }
  const std::string extension = std::filesystem::path(path).extension();
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  if (extension == ".vtu") {
    grid = read_quietly<vtkUnstructuredGrid, vtkXMLUnstructuredGridReader>(path);
  } else if (extension == ".vtk") {
    grid = read_quietly<vtkUnstructuredGrid, vtkUnstructuredGridReader>(path);
  } else {
    return Error{ErrorCode::unsupported_format,
                 fmt::format("cannot read '{}' as a mesh: possible are .vtu, .vtk", path),
                 {},
                 {}};
  }
  const std::vector<vtkIdType> cells = grid ? triangle_cells(*grid) : std::vector<vtkIdType>();
  if (cells.empty()) {
    return Error{ErrorCode::syntax,
                 fmt::format("{}: {}", path, grid ? "no triangles in it" : "not a valid VTK file"),
                 {},
                 {}};
  }

  MeshFile mesh;
  mesh.soup.points.reserve(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p) {
    std::array<double, 3> x{};
    grid->GetPoint(p, x.data());
    mesh.soup.points.push_back({x[0], x[1]});
  }
  vtkNew<vtkIdList> nodes;
  std::vector<std::uint32_t> midpoints;
  for (const vtkIdType c : cells) {
    grid->GetCellPoints(c, nodes);
    const auto node = [&](vtkIdType i) { return static_cast<std::uint32_t>(nodes->GetId(i)); };
    mesh.soup.triangles.push_back({node(0), node(1), node(2)});
    for (vtkIdType i = 3; i < nodes->GetNumberOfIds(); ++i) midpoints.push_back(node(i));
  }
  if (!midpoints.empty()) drop_midpoints(midpoints, mesh.soup);
  mesh.arrays = cell_arrays(*grid, cells);
  mesh.soup.region = integers(mesh.arrays, {"RegionId"});
  mesh.soup.material =
      integers(mesh.arrays, {"material", "MaterialID", "mat_id", "gmsh:physical", "medit:ref"});
  return mesh;
}

}  // namespace cover
