// Where a point lies by a closed polygon.
#pragma once

#include <cstdint>
#include <span>

#include <cover/point.hpp>

namespace cover {

enum class Place : std::uint8_t { inside, border, outside };

/// Inside is what a ray from the point crosses the ring an odd number of times for.
///
/// EXACT: yes
/// Cost:  O(n)
Place place_in(std::span<const Point> ring, Point p);

}  // namespace cover
