// Reading the triangles of a mesh that a subcommand is given.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <spdlog/logger.h>

#include <cover/files.hpp>
#include <cover/point.hpp>
#include <cover/read_mesh.hpp>
#include <cover/result.hpp>
#include <cover/triangle_soup.hpp>

namespace cover::app {

/// The mesh that a subcommand is given: a file, or `-`, standard input, or a pipe without an
/// extension. Readers want a file whose extension tells the format, so a stream is copied to one,
/// in a folder that goes with this object; its format follows from how it begins.
class MeshSource {
 public:
  /// Errors: cannot_open; cannot_write, where the copy finds no room; unsupported_format, where a
  /// stream begins as no mesh that is one file.
  static Result<MeshSource> open(const std::string& given);

  /// The file to read.
  [[nodiscard]] const std::string& file() const { return file_; }
  /// The mesh, as messages call it.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// An error of reading the file, or a note, that speaks of the mesh by its name.
  [[nodiscard]] Error named(Error error) const;
  [[nodiscard]] std::string named(std::string message) const;

 private:
  std::optional<ScratchFolder> folder_;
  std::string file_, name_;
};

/// What the help of a subcommand says of meshes that are streams.
constexpr const char* kMeshStreamHelp =
    "'-' is standard input, known by how it begins: .vtu, .vtk, .vtkhdf, .msh, .xdmf, .mesh or "
    ".inp";

/// A mesh, as far as subcommands look at it.
struct MeshTriangles {
  TriangleSoup soup;
  /// False: the file has groups instead of materials, and no manifest says what they are; then
  /// soup.material holds the numbers of the groups.
  bool has_materials = true;
  std::vector<std::array<Point, 3>> middles{};        ///< as MeshFile::middles
  std::size_t cut_vertices = 0;                       ///< as MeshFile::cut_vertices
  std::size_t parts = 0;                              ///< as MeshFile::parts
  std::map<std::int64_t, std::string> group_names{};  ///< where it has groups instead
  std::vector<MeshLine> lines{};                      ///< as MeshFile::lines
  std::map<std::int64_t, std::string> line_names{};   ///< as MeshFile::line_names
  std::vector<NamedPoint> named_points{};             ///< as MeshFile::named_points
};

/// The triangles of a mesh, in any format of read_mesh(). Formats that have groups
/// instead of materials need the manifest beside the mesh. A warning tells where some triangles
/// alone have six nodes, which are left out, and where a manifest is that of another mesh.
///
/// Errors: those of read_mesh() and read_output()
Result<MeshTriangles> read_triangles(const MeshSource& source, spdlog::logger& log);

/// For those who take no MeshTriangles::middles.
void warn_of_corners(const MeshSource& source, spdlog::logger& log);

}  // namespace cover::app
