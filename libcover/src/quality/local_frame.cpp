// A difference of doubles is exact just when the error term of Knuth's two-sum is zero.
// Tested by tests/unit/quality/local_frame_test.cpp.
#include "quality/local_frame.hpp"

#include <algorithm>

namespace cover {
namespace {

bool is_exact_difference(double a, double b) {
  const double d = a - b;
  const double b_part = a - d, a_part = d + b_part;
  return (a - a_part) - (b - b_part) == 0;
}

}  // namespace

LocalFrame::LocalFrame(const std::vector<Point>& points, bool wanted) : points_(points) {
  if (!wanted || points.empty()) return;
  const Point origin = points.front();
  const bool exact = std::all_of(points.begin(), points.end(), [&](Point p) {
    return is_exact_difference(p.x, origin.x) && is_exact_difference(p.y, origin.y);
  });
  if (!exact) return;
  origin_ = origin;
  for (Point& p : points_) p = from_plane(p);
}

}  // namespace cover
