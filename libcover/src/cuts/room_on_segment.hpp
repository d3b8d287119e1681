// Whether there is room for a point on a segment, as far as rounding goes.
#pragma once

#include <span>

#include <cover/point.hpp>

namespace cover {

/// Whether `p` is farther from the line through a and b than rounding a cut of it can make.
bool is_off_line(Point a, Point b, Point p);

/// Whether `p` on ab keeps away from the other edges of the triangles on both sides, whose corners
/// opposite to ab are `apexes` and on which there may be cuts too: then rounding makes nothing
/// cross.
bool has_room_on_segment(Point a, Point b, Point p, std::span<const Point> apexes);

}  // namespace cover
