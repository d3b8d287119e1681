// Ends of lines that lie on arcs.
#pragma once

#include <optional>
#include <vector>

#include <cover/input.hpp>
#include <cover/report.hpp>

namespace cover {

/// The input with a chord's end wherever an end of a line, or of another arc's chord, lies on an
/// arc between two ends of chords: that very point, so that the line meets the arc. Without it, the
/// line would end beside the chord. Nothing if there is no such end.
///
/// An end lies on the arc that is off it by rounding, compared with the chord and with coordinates
/// and not with the radius, or by no more than `weld` of the size of the drawing; but never by more
/// than an eighth of the shortest line that ends there, so what is drawn as two lines with one
/// across stays two lines. Changes tell of every chord that is split, as of straight lines, and of
/// those that are bent to an end that is off by more than rounding. What misses an arc by more, but
/// by less than is worth a warning, is told.
///
/// REQUIRES: find_bad_arcs finds nothing
/// ENSURES:  the same of the input that is returned: no arc is bent farther off its circle
/// Cost:     O(n log n); that of a look if there are no arcs
std::optional<Input> meet_arcs(const Input& input, double weld, std::vector<Change>& changes,
                               std::vector<Note>& notes);

}  // namespace cover
