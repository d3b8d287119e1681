// VTK's readers do the reading; this file turns their data set into a CellMesh, whose borders are
// the geometry. Tested by tests/unit/vtk/read_vtk_input_test.cpp.
#include <cover/read_vtk_input.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>

#include "geom/mesh_borders.hpp"
#include "vtk/cell_values.hpp"
#include "vtk/read_data_set.hpp"

namespace cover {
namespace {

// In lower case; the first that is there counts.
constexpr std::array kMaterialArrays{
    "material", "materialid",  "mat_id",     "gmsh:physical", "medit:ref", "cellentityids",
    "regionid", "materialids", "materials",  "material_id",   "matid",     "mat",
    "phase",    "attribute",   "attributes", "region",        "region_id", "physical"};
constexpr std::array kLineArrays{"lineid", "gmsh:physical", "medit:ref"};

/// Whether an array has one number for each cell, a whole one that an int holds.
bool is_of_integers(vtkDataArray* array, vtkDataSet& data) {
  if (!is_one_per_cell(array, data)) return false;
  for (vtkIdType c = 0; c < array->GetNumberOfTuples(); ++c) {
    const double value = array->GetComponent(c, 0);
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
      return false;
  }
  return true;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// A cell array that has a name, of numbers of any kind.
struct NamedArray {
  std::string name;
  vtkDataArray* array;
  bool integers;
};

std::vector<NamedArray> cell_arrays(vtkDataSet& data) {
  std::vector<NamedArray> out;
  for (int i = 0; i < data.GetCellData()->GetNumberOfArrays(); ++i) {
    const char* name = data.GetCellData()->GetArrayName(i);
    vtkDataArray* array = data.GetCellData()->GetArray(i);
    if (name) out.push_back({name, array, is_of_integers(array, data)});
  }
  return out;
}

/// The first array of integers that has one of the names, in whatever case.
template <class Names>
vtkDataArray* first_of(const std::vector<NamedArray>& arrays, const Names& names) {
  for (const char* name : names) {
    for (const NamedArray& a : arrays)
      if (a.integers && lower(a.name) == name) return a.array;
  }
  return nullptr;
}

/// The array of integers, where there is exactly one.
vtkDataArray* only_array(const std::vector<NamedArray>& arrays) {
  const auto is_it = [](const NamedArray& a) { return a.integers; };
  if (std::count_if(arrays.begin(), arrays.end(), is_it) != 1) return nullptr;
  return std::find_if(arrays.begin(), arrays.end(), is_it)->array;
}

int value_of(vtkDataArray& array, vtkIdType cell) {
  return static_cast<int>(array.GetComponent(cell, 0));
}

/// The cells of a data set as a CellMesh.
class Converter {
 public:
  Converter(vtkDataSet& data, const std::string& path) : data_(data) { mesh_.source = path; }

  Result<CellMesh> convert() {
    if (std::optional<Error> error = read_points()) return *error;
    arrays_ = cell_arrays(data_);
    material_ = first_of(arrays_, kMaterialArrays);
    if (!material_) material_ = only_array(arrays_);
    line_ = first_of(arrays_, kLineArrays);
    vtkNew<vtkIdList> nodes;
    for (vtkIdType c = 0; c < data_.GetNumberOfCells(); ++c) {
      data_.GetCellPoints(c, nodes);
      if (std::optional<Error> error = read_cell(c, *nodes)) return *error;
    }
    if (mesh_.cells() == 0 && mesh_.lines.empty())
      return error(ErrorCode::syntax, "no polygons and no lines in it");
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] Error error(ErrorCode code, const std::string& what) const {
    return {code, fmt::format("{}: {}", mesh_.source, what), {}, {}};
  }

  std::optional<Error> read_points() {
    std::array<double, 3> first{};
    for (vtkIdType p = 0; p < data_.GetNumberOfPoints(); ++p) {
      std::array<double, 3> x{};
      data_.GetPoint(p, x.data());
      if (p == 0) first = x;
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]))
        return error(ErrorCode::non_finite_coordinate, fmt::format("point {} is not finite", p));
      if (x[2] != first[2])
        return error(ErrorCode::unsupported_format,
                     fmt::format("the mesh is not in a plane z = constant: point 0 has z = {}, "
                                 "point {} {}",
                                 first[2], p, x[2]));
      mesh_.points.push_back({x[0], x[1]});
      mesh_.point_ids.push_back(static_cast<long>(p));
    }
    return std::nullopt;
  }

  std::optional<Error> read_cell(vtkIdType c, vtkIdList& nodes) {
    for (vtkIdType k = 0; k < nodes.GetNumberOfIds(); ++k)
      if (nodes.GetId(k) < 0 || nodes.GetId(k) >= data_.GetNumberOfPoints())
        return error(
            ErrorCode::id_out_of_range,
            fmt::format("cell {} has the point {}, which is not there", c, nodes.GetId(k)));
    switch (data_.GetCellType(c)) {
      case VTK_EMPTY_CELL:
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
        return std::nullopt;
      case VTK_LINE:
      case VTK_POLY_LINE:
        add_lines(c, nodes, nodes.GetNumberOfIds());
        return std::nullopt;
      case VTK_QUADRATIC_EDGE:
        add_lines(c, nodes, 2);
        return std::nullopt;
      case VTK_TRIANGLE:
      case VTK_QUADRATIC_TRIANGLE:
        return add_cell(c, nodes, {0, 1, 2});
      case VTK_QUAD:
      case VTK_QUADRATIC_QUAD:
      case VTK_BIQUADRATIC_QUAD:
        return add_cell(c, nodes, {0, 1, 2, 3});
      case VTK_PIXEL:
        return add_cell(c, nodes, {0, 1, 3, 2});
      case VTK_TRIANGLE_STRIP:
        for (vtkIdType k = 2; k < nodes.GetNumberOfIds(); ++k)
          if (auto failed = add_cell(c, nodes, {k - 2, k - 1, k})) return failed;
        return std::nullopt;
      case VTK_POLYGON: {
        std::vector<vtkIdType> all(static_cast<std::size_t>(nodes.GetNumberOfIds()));
        for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<vtkIdType>(k);
        return add_cell(c, nodes, all);
      }
      default:
        return error(ErrorCode::unsupported_format,
                     fmt::format("cell {} is of VTK's type {}; plane meshes of triangles, "
                                 "quadrangles and polygons are read",
                                 c, data_.GetCellType(c)));
    }
  }

  void add_lines(vtkIdType c, vtkIdList& nodes, vtkIdType count) {
    for (vtkIdType k = 0; k + 1 < std::min(count, nodes.GetNumberOfIds()); ++k) {
      CellMesh::Line line;
      line.a = static_cast<std::uint32_t>(nodes.GetId(k));
      line.b = static_cast<std::uint32_t>(nodes.GetId(k + 1));
      line.id = static_cast<long>(c);
      const int number = line_ ? value_of(*line_, c) : 0;
      if (number > 0) {
        line.marker = number;
        line.name = std::to_string(number);
      }
      mesh_.lines.push_back(std::move(line));
    }
  }

  std::optional<Error> add_cell(vtkIdType c, vtkIdList& nodes,
                                const std::vector<vtkIdType>& corners) {
    if (!material_) return error(ErrorCode::syntax, no_material());
    std::vector<std::uint32_t> cell;
    for (const vtkIdType k : corners)
      if (k < nodes.GetNumberOfIds()) cell.push_back(static_cast<std::uint32_t>(nodes.GetId(k)));
    if (cell.size() < 3) return std::nullopt;
    const auto [at, is_new] =
        index_.emplace(value_of(*material_, c), static_cast<std::uint32_t>(mesh_.materials.size()));
    if (is_new) mesh_.materials.push_back(std::to_string(at->first));
    mesh_.add_cell(cell, at->second);
    return std::nullopt;
  }

  [[nodiscard]] std::string no_material() const {
    std::string names;
    for (const NamedArray& a : arrays_) {
      names += (names.empty() ? "" : ", ") + a.name;
      if (!a.integers) names += " (no whole numbers)";
    }
    return "no cell array of whole numbers called material (or MaterialID, mat_id, ...); " +
           (names.empty() ? "there are no cell arrays" : "the cell arrays are " + names);
  }

  vtkDataSet& data_;
  std::vector<NamedArray> arrays_;
  vtkDataArray* material_ = nullptr;
  vtkDataArray* line_ = nullptr;
  std::map<int, std::uint32_t> index_;
  CellMesh mesh_;
};

}  // namespace

bool is_vtk_input(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".vtu" || extension == ".vtp" || extension == ".vtk";
}

Result<Input> read_vtk_input(const std::string& path) {
  const Result<vtkSmartPointer<vtkDataSet>> data = read_data_set(path);
  if (!data) return data.error();
  Result<CellMesh> mesh = Converter(**data, path).convert();
  if (!mesh) return std::move(mesh).error();
  return borders_of(*mesh);
}

}  // namespace cover
