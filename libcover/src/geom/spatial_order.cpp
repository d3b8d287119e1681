// Ranks instead of coordinates also spread points evenly, however they are crowded in the plane.
// Tested by tests/unit/geom/spatial_order_test.cpp.
#include "geom/spatial_order.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

#include "base/sort_by_team.hpp"

namespace cover {
namespace {

constexpr int kMostLevels = 16;  ///< of the curve, so that a place on it and an index fill 64 bits

/// The place of grid point (x, y) along the Hilbert curve of that many levels.
std::uint64_t place_on_curve(std::uint32_t x, std::uint32_t y, int levels) {
  std::uint64_t place = 0;
  for (int level = levels - 1; level >= 0; --level) {
    const std::uint32_t right = x >> level & 1, upper = y >> level & 1;
    place = place << 2 | (3 * right ^ upper);
    if (upper != 0) continue;
    if (right != 0) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return place;
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Point> points, const Team& team) {
  const auto n = static_cast<std::uint32_t>(points.size());
  std::vector<std::pair<double, std::uint32_t>> by_y(n);
  for (std::uint32_t k = 0; k < n; ++k) by_y[k] = {points[k].y, k};
  sort_by_team(by_y, std::less(), team);

  const int bits = static_cast<int>(std::bit_width(n)), levels = std::min(bits, kMostLevels),
            spare = bits - levels;
  std::vector<std::uint64_t> keys(n);
  team.each_range(n, kManyAtATime, [&](std::size_t first, std::size_t last) {
    for (auto rank = static_cast<std::uint32_t>(first); rank < last; ++rank) {
      const std::uint32_t k = by_y[rank].second;
      keys[rank] = place_on_curve(k >> spare, rank >> spare, levels) << 32 | k;
    }
  });
  sort_by_team(keys, std::less(), team);
  std::vector<std::uint32_t> order(n);
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

}  // namespace cover
