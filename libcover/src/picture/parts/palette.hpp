// Colours of regions and of values.
#pragma once

#include <cstddef>

#include "picture/drawing.hpp"

namespace cover {

/// The n-th of any number of distinct, light colours; the first dozen are chosen by hand.
Colour material_colour(std::size_t n);

/// A little lighter or darker, for several regions of one material.
Colour shade(Colour colour, std::size_t variant);

/// Dark, saturated: the n-th contact.
Colour contact_colour(std::size_t n);

/// How far `value` is on the way from `low` to `high`, from 0 to 1.
/// REQUIRES: it is a number
double part_of(double value, double low, double high);

/// Perceptually even, dark blue (0) to yellow (1).
Colour value_colour(double t);

/// Grey, which no value has: for none.
inline constexpr Colour kNoValueColour{200, 200, 200};

}  // namespace cover
