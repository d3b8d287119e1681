// Tested by tests/unit/io/read_mesh/read_origin_test.cpp.
#include <cover/read_origin.hpp>

#include <filesystem>
#include <utility>

#include <cover/files.hpp>

#include "io/read_mesh/formats/pieces/read_vtm.hpp"
#include "io/read_mesh/formats/read_vtkhdf_mesh.hpp"
#include "io/report/manifest_origin.hpp"

namespace cover {
namespace {

std::optional<MeshOrigin> origin_in(StoredMesh&& stored) {
  if (stored.provenance.version.empty()) return std::nullopt;
  MeshOrigin origin{std::move(stored.provenance), stored.scale, 0};
  for (Region& region : stored.regions)
    origin.regions.push_back({std::move(region.name), std::move(region.material_name)});
  return origin;
}

/// What the file itself tells.
std::optional<MeshOrigin> read_own_origin(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".vtm") {
    Result<StoredMesh> names = read_vtm_origin(path);
    if (names) return origin_in(*std::move(names));
  }
  if (extension == ".vtkhdf") {
    Result<VtkHdfMesh> file = read_vtkhdf_mesh(path);
    if (file) return origin_in(std::move(file->names));
  }
  return std::nullopt;
}

}  // namespace

std::optional<MeshOrigin> read_origin(const std::string& path) {
  // What the mesh's own file tells is of it; a manifest may be that of an earlier mesh.
  if (std::optional<MeshOrigin> origin = read_own_origin(path)) return origin;
  return read_manifest_origin(std::filesystem::path(path).replace_extension(".json"));
}

}  // namespace cover
