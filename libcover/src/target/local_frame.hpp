// Coordinates relative to a vertex of the region.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// The coordinates in which a region is meshed: relative to its first vertex where every difference
/// is exact, else as they are. Exact differences leave all predicates as they are, and then what is
/// computed does not depend on where the region lies: after a shift that is exact on every
/// coordinate the mesh is the same, shifted.
class LocalFrame {
 public:
  explicit LocalFrame(std::span<const Point> points);

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// The same, handed over: this frame has none from then on.
  [[nodiscard]] std::vector<Point> take_points() { return std::exchange(points_, {}); }
  /// False if the coordinates are as they were.
  [[nodiscard]] bool is_shifted() const { return origin_ != Point{}; }
  /// Back to the frame of the region; rounded.
  [[nodiscard]] Point restore(Point p) const { return {p.x + origin_.x, p.y + origin_.y}; }
  /// Into the frame; rounded.
  [[nodiscard]] Point enter(Point p) const { return {p.x - origin_.x, p.y - origin_.y}; }
  /// Over the shortest edge of a triangle: what rounding its corners can change in its angles.
  [[nodiscard]] double rounding() const { return rounding_; }
  /// What restore() adds.
  [[nodiscard]] Point origin() const { return origin_; }
  /// Leaves the coordinates as they are.
  void undo(std::span<const Point> points);

 private:
  Point origin_;
  std::vector<Point> points_;
  double rounding_ = 0;
};

}  // namespace cover
