// Small sets of pixels that are no regions: noise, and the blends of two colours along a border
// whose edge was softened.
#pragma once

#include <cstddef>

#include "io/images/image_borders.hpp"

namespace cover {

/// Gives every set of fewer than `least` pixels that hang together by their sides the label of a
/// neighbour: of the one along the longest piece of its border that has `least` pixels or more.
/// Sets that have none such wait until their neighbours have become part of one. In a picture of
/// small sets alone nothing changes.
///
/// Returns: how many sets there were
/// Cost:    O(pixels) for each of at most as many rounds as sets lie behind each other
std::size_t take_in_speckles(LabelImage& image, std::size_t least);

}  // namespace cover
