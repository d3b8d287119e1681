// Tested by tests/unit/geom/rings/place_in_ring_test.cpp.
#include "geom/rings/place_in_ring.hpp"

#include <array>
#include <cstddef>

#include "geom/box.hpp"
#include "geom/predicates.hpp"

namespace cover {

Place place_in(std::span<const Point> ring, Point p) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k], b = ring[(k + 1) % ring.size()];
    const Sign side = orientation(a, b, p);
    if (side == Sign::zero && box_of(std::array{a, b}).holds(p)) return Place::border;
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if ((side == Sign::positive) == (b.y > a.y)) inside = !inside;
  }
  return inside ? Place::inside : Place::outside;
}

}  // namespace cover
