// Random devices of arcs and lines.
#pragma once

#include <cstdint>

#include <cover/input.hpp>

namespace cover::testing {

/// A polygonised circle with `chords` chords, which remember it; added to `input`.
void add_circle(Input& input, Point centre, double radius, int chords, const char* name = "",
                double turn = 0);

/// Four cells, in each of which lies a ring (thin ones too), a half disc, a lens, a rounded
/// rectangle or a gear of arcs and lines, cut into few chords or many.
Input random_arc_device(std::uint64_t seed);

}  // namespace cover::testing
