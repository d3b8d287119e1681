// Arcs that touch each other, or straight lines.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <cover/input.hpp>
#include <cover/report.hpp>

namespace cover {

/// Numbers of two circles, as in InputSegment, the smaller first, of which arcs touch and have an
/// end of chords in common there. They have nothing else in common.
using TouchingCircles = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// The input with an end of chords, the same of both, wherever two arcs touch, or an arc and a
/// straight line, which is split there. Chords, which lie inside their arcs or outside, would lie
/// apart there, or cross. Nothing if there is no such place. `circles` gets the circles that touch,
/// whether they had such an end before or not.
///
/// Curves touch that come as near as ends that are one by default, 4 units in the last place of the
/// largest coordinate, counting those of their circles; or as `weld` of the size of the drawing.
/// That is decided from the doubles of centres and radii alone. Circles that are nearly one touch
/// nowhere: the curves have to come apart within an eighth of the chords beside. Of ends that are
/// there, those are taken at which the other curve is about as near.
/// Changes tell of every place.
///
/// REQUIRES: find_bad_arcs finds nothing
/// ENSURES:  the same of the input that is returned
/// Cost:     O(n log n), while boxes around arcs meet few others; that of a look without arcs
std::optional<Input> join_touching_arcs(const Input& input, double weld, TouchingCircles& circles,
                                        std::vector<Change>& changes);

}  // namespace cover
