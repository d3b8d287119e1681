// Meshes, regions and interfaces as VTK's unstructured grids.
#pragma once

#include <span>

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLWriter.h>

#include <cover/mesh.hpp>
#include <cover/regions.hpp>

namespace cover {

/// All triangles of `mesh`, with the cell arrays that write_vtu() promises.
///
/// The grid refers to the coordinates of `mesh`, which must outlive it.
vtkSmartPointer<vtkUnstructuredGrid> grid_of(const Mesh& mesh);

/// The triangles of one region, with the same arrays and the point array GlobalNodeId: the vertex's
/// number in the whole mesh. `faces` are those of the region.
vtkSmartPointer<vtkUnstructuredGrid> grid_of_region(const Mesh& mesh,
                                                    std::span<const TriMesh::FaceHandle> faces);

/// The edges of one interface as lines with the interface's left region on their left. Cell arrays
/// LineID, LeftRegion, RightRegion, LineKind (0 interface, 1 outline, 2 slit, 3 contact), marker; point array GlobalNodeId.
vtkSmartPointer<vtkUnstructuredGrid> grid_of_interface(const Mesh& mesh, const Interface& line,
                                                       std::span<const TriMesh::EdgeHandle> edges);

/// How all our files of VTK's XML formats are written: raw appended data, 64-bit sizes, not
/// compressed.
void set_encoding(vtkXMLWriter* writer);

}  // namespace cover
