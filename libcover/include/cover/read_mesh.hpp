// Reading meshes back: triangles of any tool, and all that cover wrote (target cover::vtk).
#pragma once

#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>
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

/// Reads the triangles of a .vtu or of a legacy .vtk file; other cells are left out. Of triangles
/// with six nodes the corners are taken, and points that are nothing else are left out.
///
/// Errors: cannot_open, syntax, unsupported_format
Result<MeshFile> read_mesh(const std::string& path);

/// Reads a mesh that cover wrote (.vtu, legacy .vtk or .vtm) as what cover_mesh() returned, as far
/// as files keep it; see rebuild(). Names, interfaces and markers come from the manifest (.json)
/// beside it, else from the .vtm; what is missing for want of both is said in the report's notes.
///
/// Errors: cannot_open, syntax, unsupported_format; syntax also where the manifest is of another
/// mesh.
Result<Output> read_output(const std::string& path);

}  // namespace cover
