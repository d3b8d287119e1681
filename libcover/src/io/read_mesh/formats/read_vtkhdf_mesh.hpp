// A mesh and its names from one file of VTKHDF.
#pragma once

#include <string>

#include <cover/read_mesh.hpp>
#include <cover/result.hpp>
#include <cover/stored_mesh.hpp>

#include "io/read_mesh/carried_arrays.hpp"

namespace cover {

/// The triangles and lines of a file, and what else write_vtkhdf() puts into it.
struct VtkHdfMesh {
  MeshFile mesh;  ///< groups of lines are interfaces
  bool has_names = false;
  StoredMesh names;  ///< if so: all of it but the soup, the edges and the arrays
  ArrayWords words;  ///< of arrays of triangles
};

/// Errors: those of read_vtkhdf(); syntax, where names and numbers do not fit one another
Result<VtkHdfMesh> read_vtkhdf_mesh(const std::string& path);

}  // namespace cover
