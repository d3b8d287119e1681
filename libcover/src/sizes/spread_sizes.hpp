// Sizes that grow no faster than allowed from one vertex to the next.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// Lowers `sizes` until along no edge one exceeds the other by more than `slope` times its length.
///
/// Cost: O(n log n)
void spread_sizes(std::span<const Point> points,
                  std::span<const std::pair<std::uint32_t, std::uint32_t>> edges, double slope,
                  std::vector<double>& sizes);

}  // namespace cover
