// Polygons that do not meet themselves.
#pragma once

#include <span>

#include <cover/point.hpp>

namespace cover {

/// Whether no two edges of a closed polygon meet but neighbours in their common corner.
///
/// EXACT: yes
/// Cost:  O(n log n)
bool is_simple(std::span<const Point> ring);

}  // namespace cover
