// Tested by tests/unit/io/read_mesh/read_origin_test.cpp.
#include "io/report/manifest_origin.hpp"

#include <filesystem>

#include "io/report/provenance_json.hpp"
#include "io/text/text.hpp"

namespace cover {

using Json = nlohmann::ordered_json;  // settings keep their order

bool is_manifest(const Json& json) {
  return json.is_object() && json.value("format", Json()) == "cover mesh manifest";
}

MeshOrigin origin_of(const Json& manifest) {
  return {{manifest.value("source", ""), manifest.value("cover", ""),
           options_of(manifest.value("options", Json::object()))},
          manifest.value("scale", 1.0),
          manifest.value("counts", Json::object()).value("triangles", std::size_t{})};
}

std::optional<MeshOrigin> read_manifest_origin(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) return std::nullopt;
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
