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

vtkSmartPointer<vtkPoints> points_of(const TriMesh& tri) {
  auto coordinates = vtkSmartPointer<vtkDoubleArray>::New();
  coordinates->SetNumberOfComponents(3);
  const auto values = static_cast<vtkIdType>(3 * tri.n_vertices());
  if (values > 0) {
    // VTK wants a pointer to mutable data, but only reads it; 1: the memory stays ours.
    coordinates->SetArray(const_cast<double*>(tri.points()->data()), values, 1);
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

/// Cells of `N` corners each, as indices of vertices.
template <std::size_t N>
using Corners = std::vector<std::array<int, N>>;

Corners<3> corners_of(const TriMesh& tri, std::span<const TriMesh::FaceHandle> faces) {
  Corners<3> corners;
  corners.reserve(faces.size());
  for (const TriMesh::FaceHandle face : faces) {
    const auto h = tri.halfedge_handle(face);
    corners.push_back({tri.from_vertex_handle(h).idx(), tri.to_vertex_handle(h).idx(),
                       tri.to_vertex_handle(tri.next_halfedge_handle(h)).idx()});
  }
  return corners;
}

template <std::size_t N>
vtkSmartPointer<vtkCellArray> cells_of(const Corners<N>& corners) {
  auto connectivity = vtkSmartPointer<vtkTypeInt64Array>::New();
  auto offsets = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto size = static_cast<vtkIdType>(corners.size());
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(N) * size);
  offsets->SetNumberOfValues(size + 1);
  vtkIdType k = 0;
  for (vtkIdType c = 0; c < size; ++c) {
    offsets->SetValue(c, k);
    for (const int v : corners[static_cast<std::size_t>(c)]) connectivity->SetValue(k++, v);
  }
  offsets->SetValue(size, k);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

/// A grid of its own points: those of `corners`, in the order of their numbers in the whole mesh,
/// which the point array GlobalNodeId keeps. Renumbers `corners`.
template <std::size_t N>
vtkSmartPointer<vtkUnstructuredGrid> part_of(const TriMesh& tri, Corners<N>& corners, int type) {
  std::vector<int> vertices;
  for (const auto& cell : corners) vertices.insert(vertices.end(), cell.begin(), cell.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (auto& cell : corners) {
    for (int& v : cell) {
      v = static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                           vertices.begin());
    }
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName("GlobalNodeId");
  for (const int v : vertices) {
    points->InsertNextPoint(tri.point(TriMesh::VertexHandle(v)).data());
    ids->InsertNextValue(v);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(type, cells_of(corners));
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
std::array<double, 2> extreme_angles(const TriMesh& tri, const std::array<int, 3>& cell) {
  std::array<Point, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    const TriMesh::Point& q = tri.point(TriMesh::VertexHandle(cell[i]));
    p[i] = {q[0], q[1]};
  }
  const std::array angles{angle_at(p[1], p[0], p[2]), angle_at(p[2], p[1], p[0]),
                          angle_at(p[0], p[2], p[1])};
  const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
  return {Angle::radians(*high).in_degrees(), Angle::radians(*low).in_degrees()};
}

/// The arrays of the cells. Several names for one thing: every solver looks for its own, some only
/// for the first array.
///
/// Their order is one that meshio can read. It replaces the offset of each appended array by a
/// larger one, 4/3 of it, and then takes the first array that has the next offset it looks for:
/// with four arrays of integers in front, every third mesh came out wrong or not at all.
void add_face_arrays(const Mesh& mesh, std::span<const TriMesh::FaceHandle> faces,
                     const Corners<3>& corners, vtkCellData* data) {
  using Face = TriMesh::FaceHandle;
  std::vector<std::array<double, 2>> angles;
  angles.reserve(corners.size());
  for (const auto& cell : corners) angles.push_back(extreme_angles(mesh.tri(), cell));
  const auto material = [&](Face f) { return mesh.material(f); };
  const auto region = [&](Face f) { return static_cast<int>(mesh.region(f).value()); };
  const auto largest = [](const std::array<double, 2>& angle) { return angle[0]; };
  const auto smallest = [](const std::array<double, 2>& angle) { return angle[1]; };
  data->SetScalars(cell_array<vtkIntArray>("material", faces, material));
  data->AddArray(cell_array<vtkIntArray>("MaterialID", faces, material));
  data->AddArray(cell_array<vtkDoubleArray>("max_angle", angles, largest));
  data->AddArray(cell_array<vtkIntArray>("mat_id", faces, material));
  data->AddArray(cell_array<vtkIntArray>("RegionId", faces, region));
  data->AddArray(cell_array<vtkDoubleArray>("min_angle", angles, smallest));
}

/// The half-edge of `edge` with the left region of `line` on its left.
TriMesh::HalfedgeHandle directed(const Mesh& mesh, const Interface& line,
                                 TriMesh::EdgeHandle edge) {
  const auto h = mesh.tri().halfedge_handle(edge, 0);
  const auto face = mesh.tri().face_handle(h);
  return face.is_valid() && mesh.region(face) == line.left ? h
                                                           : mesh.tri().halfedge_handle(edge, 1);
}

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> grid_of(const Mesh& mesh) {
  const TriMesh& tri = mesh.tri();
  std::vector<TriMesh::FaceHandle> faces(tri.faces_begin(), tri.faces_end());
  const Corners<3> corners = corners_of(tri, faces);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points_of(tri));
  grid->SetCells(VTK_TRIANGLE, cells_of(corners));
  add_face_arrays(mesh, faces, corners, grid->GetCellData());
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> grid_of_region(const Mesh& mesh,
                                                    std::span<const TriMesh::FaceHandle> faces) {
  const Corners<3> corners = corners_of(mesh.tri(), faces);
  Corners<3> local = corners;
  auto grid = part_of(mesh.tri(), local, VTK_TRIANGLE);
  add_face_arrays(mesh, faces, corners, grid->GetCellData());
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> grid_of_interface(const Mesh& mesh, const Interface& line,
                                                       std::span<const TriMesh::EdgeHandle> edges) {
  Corners<2> corners;
  for (const TriMesh::EdgeHandle edge : edges) {
    const auto h = directed(mesh, line, edge);
    corners.push_back(
        {mesh.tri().from_vertex_handle(h).idx(), mesh.tri().to_vertex_handle(h).idx()});
  }
  auto grid = part_of(mesh.tri(), corners, VTK_LINE);
  const auto constant = [](auto id) {
    return [value = static_cast<int>(id.value())](TriMesh::EdgeHandle) { return value; };
  };
  vtkCellData* data = grid->GetCellData();
  data->SetScalars(cell_array<vtkIntArray>("LineID", edges, constant(line.id)));
  data->AddArray(cell_array<vtkIntArray>("LeftRegion", edges, constant(line.left)));
  data->AddArray(cell_array<vtkIntArray>("RightRegion", edges, constant(line.right)));
  data->AddArray(cell_array<vtkIntArray>(
      "LineKind", edges, [&](TriMesh::EdgeHandle) { return static_cast<int>(line.kind); }));
  data->AddArray(cell_array<vtkIntArray>("marker", edges,
                                         [&](TriMesh::EdgeHandle e) { return mesh.marker(e); }));
  return grid;
}

void set_encoding(vtkXMLWriter* writer) {
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
}

}  // namespace cover
