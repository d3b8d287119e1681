// Chords that cross where their arcs do not.
#pragma once

#include <optional>
#include <vector>

#include <cover/input.hpp>
#include <cover/report.hpp>

#include "clean/arcs/touching_arcs.hpp"

namespace cover {

/// The input with chords halved, on their arcs, until none crosses a chord of a circle of which
/// nothing that is drawn meets what is drawn of its own: what lies between two arcs side by side
/// would be cut to pieces otherwise. Of `touching` circles none may cross either, and where one
/// touches another from inside, the chords of the larger one leave the place beyond those of the
/// smaller one. Of two chords that cross, those are halved that cut off a part of the other, and
/// none more than eight times, where that parts them, or four times; a warning says so, and whether
/// chords are left that cross. Nothing if none does.
///
/// REQUIRES: find_bad_arcs finds nothing
/// Cost:     O(n log n), while chords meet few others; that of a look if there are no arcs
std::optional<Input> part_crossing_chords(const Input& input, const TouchingCircles& touching,
                                          std::vector<Note>& notes);

}  // namespace cover
