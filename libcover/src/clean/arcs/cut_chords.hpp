// Chords of an input, and points put between their ends.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <cover/input.hpp>

#include "geom/box.hpp"
#include "geom/curves/arc.hpp"

namespace cover {

/// A chord of an input, whichever way round it is drawn and however often.
struct InputChord {
  Point a, b;                ///< a < b
  std::uint32_t circle = 0;  ///< as in InputSegment
  friend constexpr auto operator<=>(const InputChord&, const InputChord&) = default;
};

/// The chord with these ends.
InputChord chord_between(Point a, Point b, std::uint32_t circle);

/// Of half a circle and more there is no telling on which side of its chord an arc lies.
bool is_short_enough(const ArcCircle& circle, Point a, Point b);

/// The short enough chords of an input, each once, in order.
///
/// REQUIRES: find_bad_arcs finds nothing
std::vector<InputChord> chords_of(const Input& input);

/// The arc over a chord of the input.
ArcOver arc_over(const Input& input, const InputChord& chord);

/// A box around that arc, wider by `more` on all sides.
Box box_around_arc(const Input& input, const InputChord& chord, double more);

/// By chord, or straight line with circle 0: points between its ends, in order from a to b.
using ChordCuts = std::map<InputChord, std::vector<Point>>;

/// The input with every such chord cut at its points, all pieces being chords of the same circle.
/// Pieces of a segment keep its name, its marker and its id.
Input cut_chords(const Input& input, const ChordCuts& cuts);

}  // namespace cover
