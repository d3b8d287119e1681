// How a mesh was made, as its file or the manifest beside it tells.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <cover/report.hpp>

namespace cover {

/// What a mesh calls a region.
struct RegionNames {
  std::string region;
  std::string material;
};

/// The run that wrote a mesh.
struct MeshOrigin {
  Provenance provenance;
  double scale = 1;                    ///< as Report::scale
  std::size_t triangles = 0;           ///< of the mesh that it wrote; 0: not told
  std::vector<RegionNames> regions{};  ///< by RegionId - 1; empty: not told
};

/// The run that wrote the mesh in this file, by a .vtm or a .vtkhdf itself, else by the manifest
/// (.json) beside it; nothing where neither tells, or cannot be read. A manifest may be that of
/// another mesh: its count of triangles is for the caller to compare.
///
/// Memory: that of a .vtkhdf, or of the manifest
std::optional<MeshOrigin> read_origin(const std::string& path);

}  // namespace cover
