// Tested by tests/unit/vtk/read_size_field_test.cpp.
#include <cover/read_size_field.hpp>

#include <cmath>

#include <fmt/ranges.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "base/errors.hpp"
#include "vtk/read_data_set.hpp"

namespace cover {
namespace {

/// The sizes by point, or what there is instead.
Result<vtkDataArray*> find_sizes(vtkDataSet& data, const std::string& path) {
  std::vector<vtkDataArray*> found;
  std::vector<std::string> names;
  for (int i = 0; i < data.GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data.GetPointData()->GetArray(i);
    if (array == nullptr || array->GetNumberOfComponents() != 1 ||
        array->GetNumberOfTuples() != data.GetNumberOfPoints())
      continue;
    found.push_back(array);
    names.emplace_back(array->GetName() == nullptr ? "" : array->GetName());
  }
  for (const char* name : {"size", "h"}) {
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (names[k] == name) return found[k];
    }
  }
  if (found.size() == 1) return found.front();
  if (found.empty()) return wrong_file(path, "no point array with one component, of edge lengths");
  return wrong_file(path,
               fmt::format("which point array has the edge lengths? None of {} is called size "
                           "or h",
                           fmt::join(names, ", ")));
}

/// The plane cells of `data` as triangles.
void add_triangles(vtkDataSet& data, SizeSamples& samples) {
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> places;
  for (vtkIdType c = 0; c < data.GetNumberOfCells(); ++c) {
    vtkCell* cell = data.GetCell(c);
    if (cell == nullptr || cell->GetCellDimension() != 2) continue;
    cell->Triangulate(0, ids, places);
    for (vtkIdType k = 0; k + 2 < ids->GetNumberOfIds(); k += 3) {
      samples.triangles.push_back({static_cast<std::uint32_t>(ids->GetId(k)),
                                   static_cast<std::uint32_t>(ids->GetId(k + 1)),
                                   static_cast<std::uint32_t>(ids->GetId(k + 2))});
    }
  }
}

}  // namespace

Result<SizeSamples> read_size_field(const std::string& path) {
  const Result<vtkSmartPointer<vtkDataSet>> data = read_data_set(path);
  if (!data) return data.error();
  const Result<vtkDataArray*> sizes = find_sizes(**data, path);
  if (!sizes) return sizes.error();
  SizeSamples samples;
  for (vtkIdType p = 0; p < (*data)->GetNumberOfPoints(); ++p) {
    std::array<double, 3> x{};
    (*data)->GetPoint(p, x.data());
    samples.points.push_back({x[0], x[1]});
    samples.sizes.push_back((*sizes)->GetComponent(p, 0));
  }
  add_triangles(**data, samples);
  return samples;
}

Status load_size_field(Options& options) {
  if (options.size_field || options.size_field_name.empty()) return ok();
  const Result<SizeSamples> samples = read_size_field(options.size_field_name);
  if (!samples) return samples.error();
  Result<SizeFunction> sizes = size_function(*samples, options.growth.value_or(Options::kGrowth));
  if (!sizes) {
    Error error = std::move(sizes).error();
    error.message = fmt::format("{}: {}", options.size_field_name, error.message);
    return error;
  }
  options.size_field = *std::move(sizes);
  return ok();
}

}  // namespace cover
