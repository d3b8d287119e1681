// Tested by tests/unit/covering/almond_test.cpp.
#include "covering/local_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cover {
namespace {

/// True if a - b needs no rounding (the error term of the two-sum is zero).
bool is_exact_difference(double a, double b) {
  const double d = a - b, b_part = a - d, a_part = d + b_part;
  return (a - a_part) - (b - b_part) == 0;
}

}  // namespace

LocalFrame::LocalFrame(std::span<const Point> points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  rounding_ = 4 * (std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest);
  const bool exact = std::all_of(points.begin(), points.end(), [&](const Point& p) {
    return is_exact_difference(p.x, points[0].x) && is_exact_difference(p.y, points[0].y);
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
