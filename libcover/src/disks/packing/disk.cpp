// Tested by tests/unit/disks/packing/search/apollonius_test.cpp.
#include "disks/packing/disk.hpp"

#include <cmath>

#include "base/numbers.hpp"

namespace cover::disks {

Element make_disk(Point centre, double radius, Index vertex) {
  Element e;
  e.shape = Element::Shape::disk;
  e.id = vertex;
  e.c = centre;
  e.r = radius;
  return e;
}

Element make_line(Point a, Point b, Index chord) {
  Element e;
  e.shape = Element::Shape::line;
  e.id = chord;
  e.c = a;
  const double l = norm(b - a);
  e.d = (1 / l) * (b - a);
  e.to = l;
  return e;
}

double signed_distance(const Element& e, Point x) {
  return e.is_disk() ? norm(x - e.c) - e.r : cross(e.d, x - e.c);
}

double obstacle_distance(const Element& e, Point x) {
  if (e.is_disk()) return norm(x - e.c) - e.r;
  const double t = dot(e.d, x - e.c);
  if (t < e.from || t > e.to) return kInfinity;
  return std::abs(cross(e.d, x - e.c));
}

Point contact(const Element& e, Point x) {
  if (e.is_line()) return e.c + dot(e.d, x - e.c) * e.d;
  const Vector v = x - e.c;
  return e.c + (e.r / norm(v)) * v;
}

Vector outward(const Element& e, Point q) {
  if (e.is_line()) return left_normal(e.d);
  const Vector v = q - e.c;
  return (1 / norm(v)) * v;
}

double ccw_angle(Vector a, Vector b) {
  const double angle = std::atan2(cross(a, b), dot(a, b));
  return angle < 0 ? angle + kFullTurn : angle;
}

double way_back(const Element& e, Point from, Point to) {
  return e.is_disk() ? ccw_angle(from - e.c, to - e.c) : dot(e.d, from - to);
}

}  // namespace cover::disks
