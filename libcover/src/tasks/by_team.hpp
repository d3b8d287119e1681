// A stage that is one piece of work for several threads.
#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/run_all.hpp"
#include "base/team.hpp"
#include "tasks/errors_as_values.hpp"

namespace cover {

/// Calls `body` with a team of `workers` threads, the caller's among them; what it throws becomes
/// an error, see errors_as_values().
template <class Body>
std::invoke_result_t<Body, const Team&> by_team(std::string_view doing, unsigned workers,
                                                const Body& body) {
  std::optional<std::invoke_result_t<Body, const Team&>> result;
  run_all(1, workers, [&](std::size_t, const Team& team) {
    result.emplace(errors_as_values(doing, [&] { return body(team); }));
  });
  return *std::move(result);
}

}  // namespace cover
