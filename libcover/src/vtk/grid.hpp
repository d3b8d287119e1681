// Meshes, regions and interfaces as VTK's unstructured grids.
#pragma once

#include <span>

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLWriter.h>

#include <cover/regions.hpp>

#include "io/write_mesh/mesh_view.hpp"

namespace cover {

/// All triangles, with the cell arrays that write_vtu() promises.
vtkSmartPointer<vtkUnstructuredGrid> grid_of(const MeshView& view);

/// Some triangles, with the same arrays and the point array GlobalNodeId: the number of a point in
/// the whole mesh.
vtkSmartPointer<vtkUnstructuredGrid> grid_of_triangles(const MeshView& view,
                                                       std::span<const std::size_t> triangles);

/// Some lines, with their left region on the left. Cell arrays LineID (InterfaceId), LeftRegion,
/// RightRegion, LineKind (0 interface, 1 outline, 2 slit, 3 contact), marker; point array
/// GlobalNodeId.
///
/// REQUIRES: each of them is on an interface
vtkSmartPointer<vtkUnstructuredGrid> grid_of_lines(const MeshView& view, const RegionTable& table,
                                                   std::span<const std::size_t> lines);

/// How all our files of VTK's XML formats are written: raw appended data, 64-bit sizes, not
/// compressed.
void set_encoding(vtkXMLWriter* writer);

}  // namespace cover
