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
  return MeshOrigin{std::move(stored.provenance), stored.scale, 0};
}

}  // namespace

std::optional<MeshOrigin> read_origin(const std::string& path) {
  const std::string manifest = std::filesystem::path(path).replace_extension(".json");
  if (std::optional<MeshOrigin> origin = read_manifest_origin(manifest)) return origin;
  if (extension_of(path) == ".vtm") {
    Result<StoredMesh> names = read_vtm_origin(path);
    if (names) return origin_in(*std::move(names));
  }
  if (extension_of(path) == ".vtkhdf") {
    Result<VtkHdfMesh> file = read_vtkhdf_mesh(path);
    if (file) return origin_in(std::move(file->names));
  }
  return std::nullopt;
}

}  // namespace cover
