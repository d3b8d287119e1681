// How a mesh came about, as JSON: the same in the manifest and in the report.
#pragma once

#include <nlohmann/json.hpp>

#include <cover/report.hpp>

namespace cover {

/// { name: value }; an option that was given several times has a list.
nlohmann::ordered_json options_json(const Provenance& provenance);

/// The other way.
/// Errors: throws what nlohmann's library does where `json` is something else.
std::vector<Provenance::Setting> options_of(const nlohmann::ordered_json& json);

}  // namespace cover
