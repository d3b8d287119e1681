// A mesh within the bound has a vertex in the circle of each triangle beyond it. Where half discs
// cover all that the circle has of the region, one of their sides has a negative coupling.
//
// Tested by tests/unit/limits/couplings/half_disc_room_test.cpp.
#include "limits/couplings/forced_sides.hpp"

#include <algorithm>
#include <iterator>

#include "geom/vector.hpp"
#include "limits/couplings/half_disc_room.hpp"

namespace cover {
namespace {

constexpr std::size_t kMostCircles = 8;  ///< that proofs look at

}  // namespace

std::vector<std::uint32_t> forced_sides(std::span<const Point> points,
                                        std::span<const IndexPair> sides,
                                        const std::vector<bool>& is_free,
                                        std::span<const std::array<Point, 3>> beyond,
                                        std::span<const std::uint32_t> negative) {
  std::vector<std::uint32_t> forced;
  if (negative.empty() || beyond.empty()) return forced;
  const HalfDiscRoom room(points, sides, is_free);
  std::vector<bool> is_taken(sides.size(), false);  // by a proof
  std::size_t circles = 0;
  for (const std::array<Point, 3>& corners : beyond) {
    const HalfDiscRoom::Circle circle = HalfDiscRoom::circle_through(corners);
    const auto is_near = [&](std::uint32_t s) {
      const Point a = points[sides[s][0]], b = points[sides[s][1]];
      return length(midpoint(a, b) - circle.middle) < circle.radius + length(b - a);
    };
    if (std::none_of(negative.begin(), negative.end(), is_near)) continue;
    if (++circles > kMostCircles) break;
    const HalfDiscRoom::Room found = room.within_circle(corners, 0, negative);
    if (!found.is_none || std::any_of(found.sides.begin(), found.sides.end(),
                                      [&](std::uint32_t s) { return is_taken[s]; }))
      continue;
    std::vector<std::uint32_t> common;
    std::vector<std::uint32_t> sorted(negative.begin(), negative.end());
    std::sort(sorted.begin(), sorted.end());
    std::set_intersection(sorted.begin(), sorted.end(), found.sides.begin(), found.sides.end(),
                          std::back_inserter(common));
    if (common.empty()) continue;  // an inner edge is negative, or the bound is not held
    forced.push_back(common[0]);
    for (const std::uint32_t s : found.sides) is_taken[s] = true;
  }
  return forced;
}

void tell_forced(std::span<const Point> points, std::span<const IndexPair> sides,
                 const std::vector<bool>& is_free, std::span<const std::array<Point, 3>> beyond,
                 std::span<NegativeCoupling* const> given_up) {
  std::vector<std::uint32_t> negative;
  std::vector<NegativeCoupling*> of_side(sides.size(), nullptr);
  for (NegativeCoupling* c : given_up) {
    for (std::uint32_t s = 0; s < sides.size(); ++s) {
      if (!is_free[s] || points[sides[s][0]] != c->a || points[sides[s][1]] != c->b) continue;
      negative.push_back(s);
      of_side[s] = c;
    }
  }
  for (const std::uint32_t s : forced_sides(points, sides, is_free, beyond, negative))
    of_side[s]->kind = NegativeCoupling::Kind::forced;
}

}  // namespace cover
