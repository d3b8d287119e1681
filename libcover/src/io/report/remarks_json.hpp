// What a run remarks on, and what it changed of the input, as JSON.
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include <cover/change.hpp>
#include <cover/report.hpp>

namespace cover {

/// [ { "kind", "message", "where": [[x, y], ...] } ]
nlohmann::ordered_json notes_json(const std::vector<Note>& notes);

/// { "kind", "message", "where", "inputs" }
nlohmann::ordered_json change_json(const Change& change);

}  // namespace cover
