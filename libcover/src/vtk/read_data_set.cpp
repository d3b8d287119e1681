// Tested by tests/unit/vtk/read_vtk_input_test.cpp.
#include "vtk/read_data_set.hpp"

#include <filesystem>

#include <fmt/core.h>
#include <vtkDataSetReader.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "vtk/read_quietly.hpp"

namespace cover {
namespace {

vtkSmartPointer<vtkDataSet> read(const std::string& path, const std::string& extension) {
  if (extension == ".vtu") return read_quietly<vtkDataSet, vtkXMLUnstructuredGridReader>(path);
  if (extension == ".vtp") return read_quietly<vtkDataSet, vtkXMLPolyDataReader>(path);
  return read_quietly<vtkDataSet, vtkDataSetReader>(path);
}

}  // namespace

Result<vtkSmartPointer<vtkDataSet>> read_data_set(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".vtu" && extension != ".vtp" && extension != ".vtk")
    return Error{ErrorCode::unsupported_format,
                 fmt::format("{}: not named like a file of VTK: .vtu, .vtp or .vtk", path),
                 {},
                 {}};
  if (!std::filesystem::is_regular_file(path))
    return Error{ErrorCode::cannot_open, fmt::format("cannot open {}", path), {}, {}};
  const vtkSmartPointer<vtkDataSet> data = read(path, extension);
  if (!data) return Error{ErrorCode::syntax, fmt::format("{}: VTK cannot read it", path), {}, {}};
  return data;
}

}  // namespace cover
