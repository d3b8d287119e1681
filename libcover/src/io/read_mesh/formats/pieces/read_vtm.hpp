// The mesh that a .vtm and its pieces hold.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <cover/read_mesh.hpp>
#include <cover/result.hpp>
#include <cover/stored_mesh.hpp>

#include "io/read_mesh/carried_arrays.hpp"

namespace cover {

/// A mesh, triangles by block, and its arrays.
struct VtmMesh {
  StoredMesh mesh;
  std::vector<CellArray> of_triangles;
  std::vector<PlaneField::Array> of_points;
  RegionValues region_values;  ///< of `of_points`
  ArrayWords words;
  bool has_periodic_points = false;
  bool has_names = false;  ///< as the input has them; files of old versions have those of blocks
  std::vector<std::array<Point, 3>> middles;  ///< as MeshFile::middles

  /// The mesh with its arrays, triangles in their order again; `notes` tell what is left out.
  StoredMesh finish(std::vector<std::string>& notes) &&;
};

/// Errors: cannot_open, where a piece is missing; syntax, also where it lacks what write_vtm()
///         writes
Result<VtmMesh> read_vtm(const std::string& path);

/// How the mesh was made alone, without reading its pieces; empty in files of old versions.
Result<StoredMesh> read_vtm_origin(const std::string& path);

/// The same as read_mesh() has it, triangles in their order.
Result<MeshFile> read_vtm_mesh(const std::string& path);

}  // namespace cover
