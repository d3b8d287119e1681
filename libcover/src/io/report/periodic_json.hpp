// Periodic sides as JSON: the same in the manifest and in the report.
#pragma once

#include <nlohmann/json.hpp>

#include <cover/periodic.hpp>

namespace cover {

/// { "from", "to", "map", "matrix": [[xx, xy, x0], [yx, yy, y0]] }, with "centre" and "angle" of a
/// rotation.
nlohmann::ordered_json periodic_json(const PeriodicNodes& nodes);

/// The other way, with "vertices" and "edges"; what the doubles of the matrix lack is lost.
///
/// Errors: throws what nlohmann's library does where `json` is something else.
PeriodicNodes periodic_of(const nlohmann::ordered_json& json);

}  // namespace cover
