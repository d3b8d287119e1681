// GeoJSON in files that are not named so.
#pragma once

#include <optional>
#include <string>

#include <cover/input.hpp>
#include <cover/read_options.hpp>

#include "io/text/json/json_reader.hpp"
#include "io/text/json/split_json.hpp"

namespace cover {

/// Whether a document says of what type it is, as GeoJSON does and our own form does not.
bool is_geojson(const Json& document);

/// Reads a parsed document; else as parse_geojson.
Result<Input> read_geojson(const Json& document, const std::string& source,
                           const ReadOptions& options);

/// The same of a document without its features, and these, so that there is one tree at a time;
/// nothing where something is wrong: then the whole document tells.
/// REQUIRES: the features alone were taken out
std::optional<Input> read_geojson(const SplitJson& split, const std::string& source,
                                  const ReadOptions& options);

}  // namespace cover
