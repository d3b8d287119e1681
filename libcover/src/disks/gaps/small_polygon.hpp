// The best triangulation of a small polygon by its own corners.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <cover/point.hpp>

#include "disks/packing/disk.hpp"

namespace cover::disks {

/// Worse than any angle in radians: what a triangle that is not counter-clockwise counts.
inline constexpr double kImpossible = 4;

/// Largest angle of a triangle, kImpossible if it is not counter-clockwise.
///
/// EXACT: orientation
double largest_or_impossible(Point a, Point b, Point c);

/// The triangulation of a polygon with the smallest possible largest angle.
class SmallPolygon {
 public:
  static constexpr std::size_t kMostCorners = 12;

  /// Without triangles that are above `most`, of at least a right angle: cheaper where it is known
  /// that no triangulation with one will do.
  ///
  /// REQUIRES: 3 to kMostCorners corners, counter-clockwise
  /// Cost:     O(n^3)
  explicit SmallPolygon(std::span<const Point> corners, double most = kImpossible);

  /// kImpossible if there is no triangulation (the polygon is not simple, or needs a larger angle
  /// than `most`).
  [[nodiscard]] double largest_angle() const { return cost_[0][size_ - 1]; }
  /// Its triangles, as corners of the polygon.
  /// REQUIRES: there is a triangulation.
  [[nodiscard]] std::vector<std::array<Index, 3>> triangles() const;

 private:
  std::size_t size_;
  // Of the part between corners i and j: largest angle, and the apex of the triangle on i j.
  std::array<std::array<double, kMostCorners>, kMostCorners> cost_{};
  std::array<std::array<Index, kMostCorners>, kMostCorners> apex_{};
};

}  // namespace cover::disks
