// An order of points in which neighbours in the plane are mostly neighbours in memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/point.hpp>

#include "base/team.hpp"

namespace cover {

/// The indices of `points` along a Hilbert curve through the grid of their ranks by x and by y.
///
/// REQUIRES: `points` ascend
/// ENSURES:  only comparisons of coordinates count, so that neither an exact shift nor a change of
///           the unit changes the order
/// Cost:     O(n log n)
std::vector<std::uint32_t> spatial_order(std::span<const Point> points, const Team& team = {});

}  // namespace cover
