// The promises on meshes that do not fit into memory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/result.hpp>
#include <cover/verify.hpp>

namespace cover {

/// What was found on a mesh that was looked at some regions at a time.
struct CheckInParts {
  Verification found;
  std::size_t triangles = 0;
};

/// What prepare() finds, but for lower bounds, which a check finds itself; `input` goes as soon as
/// it is clean.
///
/// Errors: those of prepare()
Result<Prepared> prepare_to_check(Input&& input, const Options& options = {});

/// Checks a mesh of `prepared` in a .vtu or .vtkhdf as verify_cover() does, without holding it:
/// regions in turn, until they have `triangles_at_a_time`.
///
/// Each part is verified with all other regions as the void, by the triangles that the file says
/// are its own; so every region is covered once, by its own triangles alone. Parts fit together
/// because all of them take the same vertex for each point of the input.
///
/// Nothing where that does not show that every promise holds: where one is broken, but also where a
/// file was written otherwise than cover does, numbers regions otherwise, or stays the same size no
/// longer. Then verify_cover() tells.
/// REQUIRES: neither VerifyOptions::allow_split, hull nor box_method
/// Cost:    O(n log n), on options.threads threads
/// Memory:  12 bytes for each segment and point of the input, and some 500 for each triangle of a
///          part, by threads
std::optional<CheckInParts> check_in_parts(const Prepared& prepared, const std::string& path,
                                           const VerifyOptions& verify, const Options& options = {},
                                           std::size_t triangles_at_a_time = 200000);

}  // namespace cover
