// Reading triangle meshes back, from any tool (target cover::vtk).
#pragma once

#include <string>
#include <vector>

#include <cover/result.hpp>
#include <cover/verify.hpp>

namespace cover {

/// Values of one triangle each.
struct CellArray {
  std::string name;
  std::vector<double> values;
};

/// What a mesh file holds, as far as triangles go.
struct MeshFile {
  TriangleSoup soup;              ///< region from RegionId, material from the first of material,
                                  ///< MaterialID, mat_id, gmsh:physical, medit:ref
  std::vector<CellArray> arrays;  ///< every numeric cell array with one component
};

/// Reads the triangles of a .vtu or of a legacy .vtk file; other cells are left out.
///
/// Errors: cannot_open, syntax, unsupported_format
Result<MeshFile> read_mesh(const std::string& path);

}  // namespace cover
