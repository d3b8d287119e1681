// Disks and lines: the elements whose arcs and pieces bound what is not yet filled.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <cover/point.hpp>

#include "base/none.hpp"
#include "geom/vector.hpp"

namespace cover::disks {

/// Index of a vertex, element, side or cycle.
using Index = std::uint32_t;

inline constexpr double kFullTurn = 2 * std::numbers::pi;

/// A solid disk, or a chord of the boundary as a line with the domain on its left. Both keep
/// every other disk out, so that a new disk can only touch them from outside.
struct Element {
  enum class Shape : std::uint8_t { disk, line };
  Shape shape = Shape::disk;
  Index id = kNone;  ///< disk: the vertex at its centre; line: index of the chord
  Point c;           ///< disk: centre; line: where the chord starts
  double r = 0;      ///< disk: radius
  Vector d;          ///< line: unit direction
  double from = 0;   ///< line: the piece between its two corners, by distance from c;
  double to = 0;     ///<       only there is it an obstacle

  [[nodiscard]] bool is_disk() const { return shape == Shape::disk; }
  [[nodiscard]] bool is_line() const { return shape == Shape::line; }
};

Element make_disk(Point centre, double radius, Index vertex);
/// REQUIRES: a != b
Element make_line(Point a, Point b, Index chord);

/// A circle that touches elements from outside.
struct Circle {
  Point c;
  double r = 0;
};

/// Length of a vector. Packings lie in the unit square, so that the squares neither overflow nor,
/// for any length that matters there, underflow, and hypot() is not needed.
inline double norm(Vector v) { return std::sqrt(dot(v, v)); }

/// Distance from `x` to the rim; negative inside a disk and behind a line.
double signed_distance(const Element& e, Point x);

/// Distance from `x` to what must stay free of disks: the disk, or the piece [from, to] of the
/// line, seen from either side; infinite where the foot on the line lies off that piece (the
/// disks at its ends are nearer).
double obstacle_distance(const Element& e, Point x);

/// Where a circle around `x` that touches the element touches it.
Point contact(const Element& e, Point x);

/// Unit normal at the point `q` of the rim, pointing away from the solid.
Vector outward(const Element& e, Point q);

/// The angle from `a` to `b`, in [0, 2 pi), turning counter-clockwise.
double ccw_angle(Vector a, Vector b);

/// How far `to` lies from `from` against the direction of the side: counter-clockwise angle on a
/// disk, distance back along a line.
double way_back(const Element& e, Point from, Point to);

}  // namespace cover::disks
