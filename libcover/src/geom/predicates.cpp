// A forward error bound decides nearly every call; the rest goes to exact arithmetic.
// Bounds for orientation and in_circle: J. R. Shewchuk, Adaptive precision floating-point
// arithmetic, DCG 18 (1997), stage A; valid as long as no product under- or overflows, which
// is checked by the size of the permanent. Tested by tests/unit/geom/predicates_test.cpp.
#include "geom/predicates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <cmath>

namespace cover {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_rational;

constexpr double kEpsilon = 0x1p-53;                                  // half an ulp of 1
constexpr double kOrientationBound = (3 + 16 * kEpsilon) * kEpsilon;  // Shewchuk, fig. 21
constexpr double kInCircleBound = (10 + 96 * kEpsilon) * kEpsilon;    // Shewchuk, fig. 23
constexpr double kSafeSmall = 0x1p-900;  // no product of the filters below has lost bits

Sign sign_of(double x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; }
Sign sign_of(const Exact& x) { return static_cast<Sign>(static_cast<int>(CGAL::sign(x))); }
Kernel::Point_2 to_cgal(Point p) { return {p.x, p.y}; }

struct ExactVector {
  Exact x, y;
  ExactVector(Point from, Point to)
      : x(Exact(to.x) - Exact(from.x)), y(Exact(to.y) - Exact(from.y)) {}
};

}  // namespace

Sign orientation(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double permanent = std::abs(left) + std::abs(right);
  if (permanent > kSafeSmall && std::abs(det) > kOrientationBound * permanent) return sign_of(det);
  return static_cast<Sign>(static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c))));
}

Sign cross_sign(Point a, Point b, Point c, Point d) {
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
  const double det = left - right, permanent = std::abs(left) + std::abs(right);
  if (permanent > kSafeSmall && std::abs(det) > kOrientationBound * permanent) return sign_of(det);
  const ExactVector u(a, b), v(c, d);
  return sign_of(Exact(u.x * v.y - u.y * v.x));
}

Sign in_circle(Point a, Point b, Point c, Point d) {
  const double adx = a.x - d.x, ady = a.y - d.y;
  const double bdx = b.x - d.x, bdy = b.y - d.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  const double bc = bdx * cdy, cb = cdx * bdy;
  const double ca = cdx * ady, ac = adx * cdy;
  const double ab = adx * bdy, ba = bdx * ady;
  const double a2 = adx * adx + ady * ady;
  const double b2 = bdx * bdx + bdy * bdy;
  const double c2 = cdx * cdx + cdy * cdy;
  const double det = a2 * (bc - cb) + b2 * (ca - ac) + c2 * (ab - ba);
  const double permanent = (std::abs(bc) + std::abs(cb)) * a2 + (std::abs(ca) + std::abs(ac)) * b2 +
                           (std::abs(ab) + std::abs(ba)) * c2;
  if (permanent > kSafeSmall && std::abs(det) > kInCircleBound * permanent) return sign_of(det);
  return static_cast<Sign>(static_cast<int>(
      CGAL::side_of_oriented_circle(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d))));
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
