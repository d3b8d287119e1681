// How often a segment must be cut, at least, so that no piece has a visible vertex in its open
// diametral disk.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "box/obstacles.hpp"

namespace cover {

/// The end, in (start, 1], of the longest piece from `start` on in whose open diametral disk none
/// of the obstacles lies; rounded towards 1 by no less than the obstacles may be off.
///
/// `first` is the index of an obstacle before which none is beyond `start`.
/// Cost: the number of obstacles along the piece
double longest_piece(std::span<const Obstacle> obstacles, double start, std::size_t first);

/// No fewer points cut a segment into such pieces, whatever is done elsewhere.
///
/// REQUIRES: `obstacles` by their place along the segment
/// Cost:     O(obstacles + cuts)
/// Ref:      docs/box_method.md, Theorem 3
std::size_t least_cuts(std::span<const Obstacle> obstacles);

}  // namespace cover
