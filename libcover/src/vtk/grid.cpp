#include "vtk/grid.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "geom/vector.hpp"

namespace cover {
namespace {

/// The cells `chosen` of `cells`, with the numbers of their nodes in the whole mesh.
Cells some_of(const Cells& cells, std::span<const std::size_t> chosen) {
  Cells some{cells.nodes_each, {}};
  some.nodes.reserve(cells.nodes_each * chosen.size());
  for (const std::size_t k : chosen) {
    const auto nodes = cells[k];
    some.nodes.insert(some.nodes.end(), nodes.begin(), nodes.end());
  }
  return some;
}

vtkSmartPointer<vtkPoints> points_of(const std::vector<Point>& points) {
  auto coordinates = vtkSmartPointer<vtkDoubleArray>::New();
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  double* out = coordinates->GetPointer(0);
  for (const Point& p : points) {
    *out++ = p.x;
    *out++ = p.y;
    *out++ = 0;
  }
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(coordinates);
  return result;
}

vtkSmartPointer<vtkCellArray> cells_of(const Cells& cells) {
  auto connectivity = vtkSmartPointer<vtkTypeInt64Array>::New();
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(cells.nodes.size()));
  std::copy(cells.nodes.begin(), cells.nodes.end(), connectivity->GetPointer(0));
  auto offsets = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto size = static_cast<vtkIdType>(cells.size());
  offsets->SetNumberOfValues(size + 1);
  for (vtkIdType c = 0; c <= size; ++c)
    offsets->SetValue(c, c * static_cast<vtkIdType>(cells.nodes_each));
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(offsets, connectivity);
  return array;
}

int type_of_triangles(const MeshView& view) {
  return view.second_order() ? VTK_QUADRATIC_TRIANGLE : VTK_TRIANGLE;
}

/// A grid of its own points: those of `cells`, in the order of their numbers in the whole mesh,
/// which the point array GlobalNodeId keeps.
vtkSmartPointer<vtkUnstructuredGrid> part_of(const MeshView& view, Cells cells, int type) {
  std::vector<std::uint32_t> numbers = cells.nodes;
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (std::uint32_t& node : cells.nodes) {
    node = static_cast<std::uint32_t>(std::lower_bound(numbers.begin(), numbers.end(), node) -
                                      numbers.begin());
  }
  std::vector<Point> points;
  points.reserve(numbers.size());
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName("GlobalNodeId");
  for (const std::uint32_t number : numbers) {
    points.push_back(view.points[number]);
    ids->InsertNextValue(number);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points_of(points));
  grid->SetCells(type, cells_of(cells));
  grid->GetPointData()->SetGlobalIds(ids);
  return grid;
}

/// `value` of every item as a cell array.
template <class Array, class Items, class Value>
vtkSmartPointer<Array> cell_array(const char* name, const Items& items, Value value) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(items.size()));
  for (std::size_t k = 0; k < items.size(); ++k) {
    array->SetValue(static_cast<vtkIdType>(k), value(items[k]));
  }
  return array;
}

/// The largest and the smallest angle of a triangle, in degrees.
std::array<double, 2> extreme_angles(const MeshView& view, std::size_t triangle) {
  const auto corners = view.triangles[triangle];
  const Point p = view.points[corners[0]], q = view.points[corners[1]], r = view.points[corners[2]];
  const std::array angles{angle_at(q, p, r), angle_at(r, q, p), angle_at(p, r, q)};
  const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
  return {Angle::radians(*high).in_degrees(), Angle::radians(*low).in_degrees()};
}

/// The arrays of the cells. Several names for one thing: every solver looks for its own, some only
/// for the first array.
///
/// Their order is one that meshio can read. It replaces the offset of each appended array by a
/// larger one, 4/3 of it, and then takes the first array that has the next offset it looks for:
/// with four arrays of integers in front, every third mesh came out wrong or not at all.
void add_triangle_arrays(const MeshView& view, std::span<const std::size_t> triangles,
                         vtkCellData* data) {
  std::vector<std::array<double, 2>> angles;
  angles.reserve(triangles.size());
  for (const std::size_t t : triangles) angles.push_back(extreme_angles(view, t));
  const auto material = [&](std::size_t t) { return view.material[t]; };
  const auto region = [&](std::size_t t) { return static_cast<int>(view.region[t].value()); };
  const auto largest = [](const std::array<double, 2>& angle) { return angle[0]; };
  const auto smallest = [](const std::array<double, 2>& angle) { return angle[1]; };
  data->SetScalars(cell_array<vtkIntArray>("material", triangles, material));
  data->AddArray(cell_array<vtkIntArray>("MaterialID", triangles, material));
  data->AddArray(cell_array<vtkDoubleArray>("max_angle", angles, largest));
  data->AddArray(cell_array<vtkIntArray>("mat_id", triangles, material));
  data->AddArray(cell_array<vtkIntArray>("RegionId", triangles, region));
  data->AddArray(cell_array<vtkDoubleArray>("min_angle", angles, smallest));
}

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> grid_of(const MeshView& view) {
  std::vector<std::size_t> all(view.triangles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points_of(view.points));
  grid->SetCells(type_of_triangles(view), cells_of(view.triangles));
  add_triangle_arrays(view, all, grid->GetCellData());
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> grid_of_triangles(const MeshView& view,
                                                       std::span<const std::size_t> triangles) {
  auto grid = part_of(view, some_of(view.triangles, triangles), type_of_triangles(view));
  add_triangle_arrays(view, triangles, grid->GetCellData());
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> grid_of_lines(const MeshView& view, const RegionTable& table,
                                                   std::span<const std::size_t> lines) {
  auto grid = part_of(view, some_of(view.lines, lines),
                      view.second_order() ? VTK_QUADRATIC_EDGE : VTK_LINE);
  const auto number = [](auto id) { return static_cast<int>(id.value()); };
  const auto line = [&](std::size_t l) -> const Interface& {
    return table.interfaces[view.interface[l].index() - 1];
  };
  const auto add = [&](const char* name, auto value) {
    grid->GetCellData()->AddArray(cell_array<vtkIntArray>(name, lines, value));
  };
  add("LineID", [&](std::size_t l) { return number(view.interface[l]); });
  add("LeftRegion", [&](std::size_t l) { return number(line(l).left); });
  add("RightRegion", [&](std::size_t l) { return number(line(l).right); });
  add("LineKind", [&](std::size_t l) { return static_cast<int>(line(l).kind); });
  add("marker", [&](std::size_t l) { return view.marker[l]; });
  grid->GetCellData()->SetActiveScalars("LineID");
  return grid;
}

void set_encoding(vtkXMLWriter* writer) {
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
}

}  // namespace cover
