// Tested by tests/unit/target/local_frame_test.cpp.
#include "target/local_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/double_double.hpp"
#include "geom/ulp.hpp"

namespace cover {
LocalFrame::LocalFrame(std::span<const Point> points) {
  rounding_ = 4 * spacing_of(points);
  const bool exact = std::all_of(points.begin(), points.end(), [&](const Point& p) {
    return two_difference(p.x, points[0].x).low == 0 && two_difference(p.y, points[0].y).low == 0;
  });
  if (exact && !points.empty()) origin_ = points[0];
  points_.reserve(points.size());
  for (const Point& p : points) points_.push_back({p.x - origin_.x, p.y - origin_.y});
}

void LocalFrame::undo(std::span<const Point> points) {
  origin_ = {};
  points_.assign(points.begin(), points.end());
}

}  // namespace cover
