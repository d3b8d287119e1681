// Points that a sweep stops at: ends of segments and the points where two segments cross.
#pragma once

#include <memory>
#include <optional>

#include <cover/point.hpp>

#include "geom/double_double.hpp"
#include "geom/predicates.hpp"

namespace cover {

/// A segment between two different points.
struct PlainSegment {
  Point a;
  Point b;
};

/// A point that is known exactly: given in doubles, or as the place where two segments cross.
///
/// Exact coordinates are computed when a question cannot be answered without them, which is rare.
class SweepPoint {
 public:
  explicit SweepPoint(Point given) : rounded_(given), x_{given.x, 0}, y_{given.y, 0} {}
  /// REQUIRES: the segments cross in their insides, at one point
  SweepPoint(const PlainSegment& s, const PlainSegment& t);

  /// Each coordinate rounded to the nearest double.
  [[nodiscard]] Point rounded() const { return rounded_; }
  /// True if rounding does not change it.
  [[nodiscard]] bool is_double() const { return x_is_double_ && y_is_double_; }

  /// In lexicographic order.
  /// EXACT: yes. Rounding is monotone, so different roundings tell already.
  friend Sign compare(const SweepPoint& p, const SweepPoint& q);

  /// Positive if the point lies to the left of the line from a to b.
  /// EXACT: yes
  [[nodiscard]] Sign side_of(Point a, Point b) const;

  /// Sign of the distance to a minus the distance to b.
  /// EXACT: yes
  [[nodiscard]] Sign compare_distances(Point a, Point b) const;

 private:
  struct Exact;
  [[nodiscard]] const Exact& exact() const;
  /// side_of, if twice the digits of a double tell it.
  [[nodiscard]] std::optional<Sign> side_estimate(Point a, Point b) const;

  Point rounded_;
  bool x_is_double_ = true;
  bool y_is_double_ = true;
  DoubleDouble x_, y_;  ///< the coordinates up to these errors
  double x_error_ = 0;
  double y_error_ = 0;
  PlainSegment s_, t_;                          ///< only where they cross
  mutable std::shared_ptr<const Exact> exact_;  ///< null: not asked for yet
};

/// How far p is from the line of s, measured along y; not a number where that overflows.
///
/// Accurate to 2^-90 of the coordinates.
double distance_along_y(const PlainSegment& s, Point p);

}  // namespace cover
