#include "vtk/grid.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>
#include <cmath>

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

std::array<int, 3> corners(const TriMesh& tri, TriMesh::FaceHandle face) {
  const auto h = tri.halfedge_handle(face);
  return {tri.from_vertex_handle(h).idx(), tri.to_vertex_handle(h).idx(),
          tri.to_vertex_handle(tri.next_halfedge_handle(h)).idx()};
}

vtkSmartPointer<vtkCellArray> cells_of(const TriMesh& tri) {
  auto connectivity = vtkSmartPointer<vtkTypeInt64Array>::New();
  auto offsets = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto faces = static_cast<vtkIdType>(tri.n_faces());
  connectivity->SetNumberOfValues(3 * faces);
  offsets->SetNumberOfValues(faces + 1);
  vtkIdType k = 0;
  for (vtkIdType f = 0; f < faces; ++f) {
    offsets->SetValue(f, k);
    for (const int v : corners(tri, TriMesh::FaceHandle(static_cast<int>(f)))) {
      connectivity->SetValue(k++, v);
    }
  }
  offsets->SetValue(faces, k);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

template <class Array>
vtkSmartPointer<Array> cell_array(const char* name, std::size_t size) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(size));
  return array;
}

/// `value` of every face as a cell array.
template <class Array, class Value>
vtkSmartPointer<Array> array_of_faces(const char* name, const TriMesh& tri, Value value) {
  auto array = cell_array<Array>(name, tri.n_faces());
  for (vtkIdType f = 0; f < static_cast<vtkIdType>(tri.n_faces()); ++f) {
    array->SetValue(f, value(TriMesh::FaceHandle(static_cast<int>(f))));
  }
  return array;
}

/// The arrays max_angle and min_angle, in degrees.
void add_angles(const TriMesh& tri, vtkCellData* data) {
  auto largest = cell_array<vtkDoubleArray>("max_angle", tri.n_faces());
  auto smallest = cell_array<vtkDoubleArray>("min_angle", tri.n_faces());
  for (vtkIdType f = 0; f < static_cast<vtkIdType>(tri.n_faces()); ++f) {
    const auto v = corners(tri, TriMesh::FaceHandle(static_cast<int>(f)));
    std::array<Point, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const TriMesh::Point& q = tri.point(TriMesh::VertexHandle(v[i]));
      p[i] = {q[0], q[1]};
    }
    const std::array angles{angle_at(p[1], p[0], p[2]), angle_at(p[2], p[1], p[0]),
                            angle_at(p[0], p[2], p[1])};
    const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
    largest->SetValue(f, Angle::radians(*high).in_degrees());
    smallest->SetValue(f, Angle::radians(*low).in_degrees());
  }
  data->AddArray(largest);
  data->AddArray(smallest);
}

}  // namespace

vtkSmartPointer<vtkUnstructuredGrid> grid_of(const Mesh& mesh) {
  const TriMesh& tri = mesh.tri();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points_of(tri));
  grid->SetCells(VTK_TRIANGLE, cells_of(tri));
  vtkCellData* data = grid->GetCellData();
  const auto material = [&](TriMesh::FaceHandle f) { return mesh.material(f); };
  // Several names for one thing: every solver looks for its own, some only for the first array.
  data->SetScalars(array_of_faces<vtkIntArray>("material", tri, material));
  data->AddArray(array_of_faces<vtkIntArray>("MaterialID", tri, material));
  data->AddArray(array_of_faces<vtkIntArray>("mat_id", tri, material));
  data->AddArray(array_of_faces<vtkIntArray>("RegionId", tri, [&](TriMesh::FaceHandle f) {
    return static_cast<int>(mesh.region(f).value());
  }));
  add_angles(tri, data);
  return grid;
}

Status write_grid(vtkUnstructuredGrid* grid, const std::string& path) {
  auto writer = vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New();
  writer->SetFileName(path.c_str());
  writer->SetInputData(grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  if (writer->Write() == 0) {
    return Error{ErrorCode::cannot_write, "cannot write " + path, {}, {}};
  }
  return ok();
}

}  // namespace cover
