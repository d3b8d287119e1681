// Meshes as VTK's unstructured grids, and these as files.
#pragma once

#include <string>

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <cover/mesh.hpp>
#include <cover/result.hpp>

namespace cover {

/// All triangles of `mesh`, with the cell arrays that write_vtu() promises.
///
/// The grid refers to the coordinates of `mesh`, which must outlive it.
vtkSmartPointer<vtkUnstructuredGrid> grid_of(const Mesh& mesh);

/// Writes `grid` to exactly this file name: raw appended data, 64-bit sizes, not compressed.
///
/// Errors: cannot_write
Status write_grid(vtkUnstructuredGrid* grid, const std::string& path);

}  // namespace cover
