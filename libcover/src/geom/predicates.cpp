// What the filters in the header leave, and the rarer predicates with theirs.
// Tested by tests/unit/geom/predicates_test.cpp.
#include "geom/predicates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <cmath>

namespace cover {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_rational;

using filter::kEpsilon;
using filter::kOrientationBound;
using filter::kSafeSmall;
using filter::sign_of;

Sign sign_of(const Exact& x) { return static_cast<Sign>(static_cast<int>(CGAL::sign(x))); }
Kernel::Point_2 to_cgal(Point p) { return {p.x, p.y}; }

struct ExactVector {
  Exact x, y;
  ExactVector(Point from, Point to)
      : x(Exact(to.x) - Exact(from.x)), y(Exact(to.y) - Exact(from.y)) {}
};

}  // namespace

Sign filter::exact_orientation(Point a, Point b, Point c) {
  return static_cast<Sign>(static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c))));
}

Sign filter::exact_in_circle(Point a, Point b, Point c, Point d) {
  return static_cast<Sign>(static_cast<int>(
      CGAL::side_of_oriented_circle(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d))));
}

Sign cross_sign(Point a, Point b, Point c, Point d) {
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
  const double det = left - right, permanent = std::abs(left) + std::abs(right);
  if (permanent > kSafeSmall && std::abs(det) > kOrientationBound * permanent) return sign_of(det);
  const ExactVector u(a, b), v(c, d);
  return sign_of(Exact(u.x * v.y - u.y * v.x));
}

Sign compare_with_120_degrees(Point a, Point p, Point b) {
  const double ux = a.x - p.x, uy = a.y - p.y, vx = b.x - p.x, vy = b.y - p.y;
  const double dot = ux * vx + uy * vy, cross = ux * vy - uy * vx;
  const double size = (std::abs(ux) + std::abs(uy)) * (std::abs(vx) + std::abs(vy));
  // dot and cross carry an error below 4 eps size each; f below 64 eps size^2.
  if (size > kSafeSmall && size < 0x1p+500) {
    if (dot > 4 * kEpsilon * size) return Sign::negative;
    if (dot < -4 * kEpsilon * size) {
      const double f = 3 * dot * dot - cross * cross;
      if (std::abs(f) > 64 * kEpsilon * size * size && size > 0x1p-400) return sign_of(f);
    }
  }
  const ExactVector u(p, a), v(p, b);
  const Exact d = u.x * v.x + u.y * v.y, c = u.x * v.y - u.y * v.x;
  if (d >= 0) return Sign::negative;
  return sign_of(Exact(3 * d * d - c * c));
}

Sign compare_with_90_degrees(Point a, Point p, Point b) {
  const double ux = a.x - p.x, uy = a.y - p.y, vx = b.x - p.x, vy = b.y - p.y;
  const double dot = ux * vx + uy * vy;
  const double size = std::abs(ux * vx) + std::abs(uy * vy);
  if (size > kSafeSmall && std::abs(dot) > 4 * kEpsilon * size) return sign_of(-dot);
  const ExactVector u(p, a), v(p, b);
  return sign_of(Exact(-(u.x * v.x + u.y * v.y)));
}

}  // namespace cover
