// Which segments of a clean PSLG are chords of arcs.
#pragma once

#include <optional>
#include <vector>

#include <cover/error.hpp>
#include <cover/input.hpp>
#include <cover/pslg.hpp>
#include <cover/report.hpp>

namespace cover {

/// What is wrong with the circles of `input`: an index out of range, a radius that is none, or ends
/// of chords that are off their circle by more than a thousandth of its radius.
///
/// Errors: id_out_of_range, coordinate_out_of_range, with places and elements
/// Cost:   O(n)
std::optional<Error> find_bad_arcs(const Input& input);

/// Fills Pslg::circles and Segment::circle: a segment between the ends of a chord of the input is
/// that chord, also where these were moved by rounding, or by welding of up to `weld` of the
/// drawing's size. Pieces of chords that other lines cut or touch end off the circle; they stay
/// straight; a note tells how many.
///
/// REQUIRES: find_bad_arcs finds nothing
/// Cost:     O(n log n) in the number of chords
void remember_arcs(const Input& input, double weld, Pslg& pslg, std::vector<Note>& notes);

}  // namespace cover
