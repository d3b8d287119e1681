// The run that a manifest is of.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include <cover/read_origin.hpp>

namespace cover {

/// Whether this is a manifest, and no report or geometry.
bool is_manifest(const nlohmann::ordered_json& json);

/// How its mesh was made.
/// Throws: nlohmann's exceptions, where a value is of another kind
MeshOrigin origin_of(const nlohmann::ordered_json& manifest);

/// The same of a file; nothing if it is not there or is no sound manifest.
std::optional<MeshOrigin> read_manifest_origin(const std::string& path);

}  // namespace cover
