// All places that keep segments from being a PSLG.
#pragma once

#include <optional>

#include <cover/error.hpp>
#include <cover/input.hpp>

namespace cover {

/// Where segments cross or overlap, or a point lies inside a segment: a sentence for each place,
/// crossings first, then overlaps. The error's code is that of its first sentence.
///
/// REQUIRES: points are all different, segments too, and none has length zero
/// EXACT:    what meets; places of crossings are rounded
/// Cost:     O((n + k) log n) for k such places
std::optional<Error> list_meetings(const Input& input);

}  // namespace cover
