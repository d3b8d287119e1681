// Coordinates that do not know where the region lies.
#pragma once

#include <vector>

#include <cover/point.hpp>

namespace cover {

/// The points of a region relative to one of them, where that loses nothing.
///
/// Constructions (circumcentres, means) round differently at different places of the plane.
/// In a frame that moves with the region they do not: after a shift that is exact on every
/// coordinate the frame's coordinates, and so the connectivity of the result, are the same.
class LocalFrame {
 public:
  /// With the first point as the origin, if all differences to it are exact doubles; else, and if
  /// not `wanted`, with the origin of the plane.
  LocalFrame(const std::vector<Point>& points, bool wanted);

  [[nodiscard]] bool is_shifted() const { return origin_ != Point{}; }
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// Back to the plane, rounded.
  [[nodiscard]] Point to_plane(Point p) const { return {p.x + origin_.x, p.y + origin_.y}; }
  /// Into the frame, rounded.
  [[nodiscard]] Point from_plane(Point p) const { return {p.x - origin_.x, p.y - origin_.y}; }

 private:
  Point origin_;
  std::vector<Point> points_;
};

}  // namespace cover
