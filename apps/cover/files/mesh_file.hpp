// Reading the triangles of a mesh that a subcommand is given.
#pragma once

#include <string>

#include <spdlog/logger.h>

#include <cover/result.hpp>
#include <cover/verify.hpp>

namespace cover::app {

/// A mesh without its lines.
struct MeshTriangles {
  TriangleSoup soup;
  /// False: the file has groups instead of materials, and no manifest says what they are; then
  /// soup.material holds the numbers of the groups.
  bool has_materials = true;
  std::vector<std::array<Point, 3>> middles{};  ///< as MeshFile::middles
  std::size_t cut_vertices = 0;                 ///< as MeshFile::cut_vertices
  std::size_t parts = 0;                        ///< as MeshFile::parts
};

/// The triangles of a mesh, in any format of read_mesh(). Formats that have groups
/// instead of materials need the manifest beside the mesh. A warning tells where midpoints of
/// second-order triangles were left out, and where a manifest is that of another mesh.
///
/// Errors: those of read_mesh() and read_output()
Result<MeshTriangles> read_triangles(const std::string& path, spdlog::logger& log);

}  // namespace cover::app
