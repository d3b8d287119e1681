// Double-precision vector arithmetic for constructions. No decision about topology is taken on it.
#pragma once

#include <algorithm>
#include <cmath>

#include <cover/angle.hpp>
#include <cover/point.hpp>

namespace cover {

/// A free vector.
struct Vector {
  double x = 0;
  double y = 0;
};

constexpr Vector operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point operator+(Point p, Vector v) { return {p.x + v.x, p.y + v.y}; }
constexpr Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vector operator*(double s, Vector v) { return {s * v.x, s * v.y}; }
constexpr double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
/// `v` turned left by 90 degrees.
constexpr Vector left_normal(Vector v) { return {-v.y, v.x}; }
constexpr double squared_length(Vector v) { return dot(v, v); }
inline double length(Vector v) { return std::hypot(v.x, v.y); }
/// Half way between; written so that it is exact where the sum is.
constexpr Point midpoint(Point a, Point b) {
  return {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
}

/// pi minus the angle a-p-b, in radians, accurate also where that angle is nearly flat.
inline double nu_at(Point a, Point p, Point b) {
  const Vector u = a - p, v = b - p;
  return std::atan2(std::abs(cross(u, v)), -dot(u, v));
}

/// nu of the largest angle of a triangle.
inline double least_nu(Point a, Point b, Point c) {
  return std::min({nu_at(c, a, b), nu_at(a, b, c), nu_at(b, c, a)});
}

/// True if the triangle has an angle above pi - nu; without an arc tangent.
///
/// REQUIRES: nu < pi/2
inline bool is_flatter(Point a, Point b, Point c, double tan_nu) {
  const Vector ab = b - a, bc = c - b, ca = a - c;
  const double area = std::abs(cross(ab, bc)) / tan_nu;
  return dot(ab, ca) > area || dot(bc, ab) > area || dot(ca, bc) > area;
}

/// The angle a-p-b in [0, pi], in radians.
inline double angle_at(Point a, Point p, Point b) {
  const Vector u = a - p, v = b - p;
  return std::atan2(std::abs(cross(u, v)), dot(u, v));
}

}  // namespace cover
