// A comb whose teeth nearly touch.
#pragma once

#include <cstdint>
#include <vector>

#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {

/// `slits` of them, `gap` wide, from y = 0 up to 1 with walls that lean by 0.001 or so; below is
/// the comb, above and in between its complement.
inline Input comb(std::uint32_t slits, double gap) {
  std::vector<Point> points{{0, -0.2}};
  const double pitch = 0.02, right = pitch * (slits + 1);
  points.push_back({right, -0.2});
  points.push_back({right, 1});
  for (std::uint32_t k = slits; k > 0; --k) {
    const double x = pitch * k, lean = 0.0015 * (k % 3) - 0.0012;
    points.push_back({x + gap / 2 + lean, 1});
    points.push_back({x + 0.52 * gap, 0});
    points.push_back({x - 0.49 * gap, 0});
    points.push_back({x - 0.53 * gap + lean, 1});
  }
  const auto left = static_cast<std::uint32_t>(points.size());
  points.insert(points.end(), {{0, 1}, {0, 1.2}, {right, 1.2}});
  std::vector<std::array<std::uint32_t, 2>> segments{
      {left, left + 1}, {left + 1, left + 2}, {left + 2, 2}};
  for (std::uint32_t k = 0; k <= left; ++k) segments.push_back({k, (k + 1) % (left + 1)});
  return testing::segments_between(points, segments);
}

}  // namespace cover
