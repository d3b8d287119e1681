// Whether points and segments are a PSLG, and if not, where.
#pragma once

#include <optional>

#include <cover/error.hpp>
#include <cover/input.hpp>

namespace cover {

/// What makes the points and segments of `input` unusable: an index out of range or a coordinate
/// that is not finite.
///
/// Cost: O(n).
std::optional<Error> find_unusable(const Input& input);

/// What keeps the points and segments of `input` from being a PSLG: the first kind found of
/// duplicate points, segments of length zero, duplicate segments (each with all its places), then
/// the first point on a segment, overlap or crossing.
///
/// REQUIRES: find_unusable finds nothing
/// EXACT:    yes
/// Cost:     O(n log n) expected.
std::optional<Error> find_unclean(const Input& input);

}  // namespace cover
