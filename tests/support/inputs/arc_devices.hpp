// Random devices of arcs and lines.
#pragma once

#include <cstdint>

#include <cover/input.hpp>

namespace cover::testing {

/// A polygonised circle with `chords` chords, which remember it; added to `input`.
void add_circle(Input& input, Point centre, double radius, int chords, const char* name = "",
                double turn = 0);

/// A disc with such a border, whose circle is number 1 of the input that it is put into.
InputPolygon disc_of(const Input& circle, const char* material);

/// Four cells, in each of which lies a ring (thin ones too), a half disc, a lens, a rounded
/// rectangle or a gear of arcs and lines, cut into few chords or many.
Input random_arc_device(std::uint64_t seed);

}  // namespace cover::testing
