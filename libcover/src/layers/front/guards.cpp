// Two convex polygons are apart if and only if the line along an edge of one of them parts them.
// Coordinates are taken relative to a corner, which keeps their digits.
// Tested by tests/unit/layers/front/guards_test.cpp.
#include "layers/front/guards.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "geom/vector.hpp"

namespace cover::layers {
namespace {

constexpr double kTouch = 1e-6;  ///< of the cell's extent

struct Extent {
  double low = kInfinity;
  double high = -kInfinity;
};

Extent extent(const Guard& guard, Point origin, Vector axis) {
  Extent out;
  for (const Point& p : guard.points()) {
    const double at = dot(p - origin, axis);
    out = {std::min(out.low, at), std::max(out.high, at)};
  }
  return out;
}

/// Whether the two are apart in the direction of `axis`, or one would be after a small move.
bool parts(const Guard& cell, const Guard& other, Vector axis) {
  const Point origin = cell.corners[0];
  const Extent a = extent(cell, origin, axis), b = extent(other, origin, axis);
  return std::min(a.high - b.low, b.high - a.low) <= kTouch * (a.high - a.low);
}

/// Whether an edge of `from` has a normal that parts the two.
bool has_parting_edge(const Guard& from, const Guard& cell, const Guard& other) {
  const auto points = from.points();
  for (std::size_t k = 0; k < points.size() && points.size() > 1; ++k) {
    const Vector edge = points[(k + 1) % points.size()] - points[k];
    if (squared_length(edge) > 0 && parts(cell, other, left_normal(edge))) return true;
    // The ends of a segment part it from what lies beyond them.
    if (points.size() == 2 && parts(cell, other, edge)) return true;
  }
  return false;
}

}  // namespace

Box Guard::box() const { return box_of(points()); }

bool overlap(const Guard& cell, const Guard& other) {
  return !has_parting_edge(cell, cell, other) && !has_parting_edge(other, cell, other);
}

}  // namespace cover::layers
