// Edges of second order that are not straight.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <cover/point.hpp>
#include <cover/triangle_soup.hpp>

namespace cover {

/// The middle nodes of edges that lie off the middles of their chords, by more than rounding of a
/// text, by lower and upper end. `middles`: as MeshFile::middles; of another size: none.
std::map<std::pair<std::uint32_t, std::uint32_t>, Point> bent_edges(
    const TriangleSoup& soup, const std::vector<std::array<Point, 3>>& middles);

}  // namespace cover
