// Tested by tests/unit/io/read_mesh/read_origin_test.cpp.
#include "io/report/manifest_origin.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ios>
#include <string>
#include <vector>

#include "io/report/provenance_json.hpp"
#include "io/text/text.hpp"

namespace cover {

using Json = nlohmann::ordered_json;  // settings keep their order

namespace {

constexpr const char* kManifest = "cover mesh manifest";

/// Whether the file begins as manifests do. Others, as the geometry of the mesh, may be large.
bool begins_as_manifest(const std::string& path) {
  std::string head(1024, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head.find(kManifest) != std::string::npos;
}

/// The count of triangles; 0: not told.
/// Throws: nlohmann's exceptions, where it is no count
std::size_t triangles_of(const Json& manifest) {
  const Json counts = manifest.value("counts", Json::object());
  const Json count = counts.value("triangles", Json(Json::number_unsigned_t{}));
  return count.get_ref<const Json::number_unsigned_t&>();
}

/// Throws: nlohmann's exceptions, where they are none
std::vector<RegionNames> region_names_of(const Json& manifest) {
  std::vector<RegionNames> names;
  for (const Json& region : manifest.value("regions", Json::array())) {
    if (region.at("id") != names.size() + 1) return {};
    names.push_back({region.at("name"), region.at("material_name")});
  }
  return names;
}

}  // namespace

bool is_manifest(const Json& json) {
  return json.is_object() && json.value("format", Json()) == kManifest;
}

MeshOrigin origin_of(const Json& manifest) {
  return {{manifest.value("source", ""), manifest.value("cover", ""),
           options_of(manifest.value("options", Json::object()))},
          manifest.value("scale", 1.0),
          triangles_of(manifest),
          region_names_of(manifest)};
}

std::optional<MeshOrigin> read_manifest_origin(const std::string& path) {
  if (!std::filesystem::is_regular_file(path) || !begins_as_manifest(path)) return std::nullopt;
  const Result<std::string> text = read_file(path);
  if (!text) return std::nullopt;
  const Json json = Json::parse(*text, nullptr, false);
  try {
    if (is_manifest(json)) return origin_of(json);
  } catch (const Json::exception&) {
    // It is broken, which readers of the mesh tell.
  }
  return std::nullopt;
}

}  // namespace cover
