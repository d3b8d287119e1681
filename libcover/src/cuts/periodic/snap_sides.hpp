// The points of periodic sides become rounded images of each other.
#pragma once

#include <vector>

#include <cover/pslg.hpp>
#include <cover/report.hpp>

#include "cuts/periodic/match_sides.hpp"

namespace cover {

/// Moves the points of each class to the images of one of them, the first. Moves beyond rounding
/// are appended to `changes`.
///
/// Returns: whether anything moved
/// Cost:    O(n log n)
bool snap_sides(Pslg& pslg, const std::vector<SidesMatch>& matches, std::vector<Change>& changes);

}  // namespace cover
