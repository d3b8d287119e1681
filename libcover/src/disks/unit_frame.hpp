// The coordinates of a packing.
#pragma once

#include <cmath>
#include <vector>

#include <cover/point.hpp>

#include "geom/box.hpp"

namespace cover::disks {

/// Translates points to the corner of their bounding box and scales them into the unit square by a
/// power of two, so that scaling the input by a power of two changes nothing.
class UnitFrame {
 public:
  explicit UnitFrame(const std::vector<Point>& points) {
    if (points.empty()) return;
    const Box box = box_of(points);
    origin_ = box.low;
    std::frexp(box.extent(), &exponent_);
  }
  [[nodiscard]] Point inward(Point p) const {
    return {std::ldexp(p.x - origin_.x, -exponent_), std::ldexp(p.y - origin_.y, -exponent_)};
  }
  [[nodiscard]] double inward(double length) const { return std::ldexp(length, -exponent_); }
  [[nodiscard]] Point outward(Point p) const {
    return {origin_.x + std::ldexp(p.x, exponent_), origin_.y + std::ldexp(p.y, exponent_)};
  }
  [[nodiscard]] double outward(double length) const { return std::ldexp(length, exponent_); }

 private:
  Point origin_;
  int exponent_ = 0;
};

}  // namespace cover::disks
