// The map of a triangle of second order is a quadratic Bezier triangle with control points C on its
// edges, m = (a + 2 C + b) / 4. Its derivatives are linear, u = sum l_i u_i and v = sum l_i v_i in
// barycentric coordinates l, so its Jacobian u x v has the coefficients u_i x v_i at the corners
// and (u_i x v_j + u_j x v_i) / 2 between them: it is their weighted mean and positive where all of
// them are. They are computed with twice the digits of a double, and exactly where that leaves
// their signs open.
//
// Ref: A. Johnen, J.-F. Remacle, C. Geuzaine, Geometrical validity of curvilinear finite elements,
//      J. Comput. Phys. 233 (2013)
// Tested by tests/unit/geom/curves/arc_test.cpp.
#include "geom/curves/arc.hpp"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>

#include "geom/double_double.hpp"
#include "geom/foot.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kOnCircle = 0x1p-40;
constexpr double kErrorOfSums = 0x1p-90;  ///< of the largest term; some 2^-98 is what is lost
constexpr double kUnderflow = 0x1p-900;   ///< products below may have lost digits
constexpr double kOverflow = 0x1p400;     ///< products of what is larger may be no numbers

/// A vector with twice the digits.
struct LongVector {
  DoubleDouble x, y;
};

LongVector operator+(const LongVector& a, const LongVector& b) { return {a.x + b.x, a.y + b.y}; }
LongVector operator-(const LongVector& a, const LongVector& b) { return {a.x - b.x, a.y - b.y}; }

LongVector long_vector(Point p) { return {{p.x, 0}, {p.y, 0}}; }

double largest_part(const LongVector& v) {
  return std::max(std::abs(v.x.high), std::abs(v.y.high));
}

DoubleDouble long_cross(const LongVector& a, const LongVector& b) { return a.x * b.y - a.y * b.x; }

using Exact = CGAL::Exact_rational;

struct ExactVector {
  Exact x, y;
};

ExactVector operator-(const ExactVector& a, const ExactVector& b) { return {a.x - b.x, a.y - b.y}; }

Exact exact_cross(const ExactVector& a, const ExactVector& b) { return a.x * b.y - a.y * b.x; }

/// The same as below, by rational numbers.
bool has_exactly_positive_jacobian(const CurvedTriangle& triangle) {
  std::array<ExactVector, 3> corner, control;
  for (std::size_t i = 0; i < 3; ++i) corner[i] = {Exact(triangle[i].x), Exact(triangle[i].y)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point m = triangle[3 + i];
    const ExactVector &a = corner[i], &b = corner[(i + 1) % 3];
    control[i] = {2 * Exact(m.x) - (a.x + b.x) / 2, 2 * Exact(m.y) - (a.y + b.y) / 2};
  }
  const std::array u{control[0] - corner[0], corner[1] - control[0], control[1] - control[2]};
  const std::array v{control[2] - corner[0], control[1] - control[0], corner[2] - control[2]};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      if (exact_cross(u[i], v[j]) + exact_cross(u[j], v[i]) <= 0) return false;
    }
  }
  return true;
}

}  // namespace

ArcOver::ArcOver(const ArcCircle& circle, Point a, Point b) : a_(a), b_(b) {
  const Point m = midpoint(a, b);
  const double half = length(b - a) / 2;
  radius_ = std::max(circle.radius, half);
  height_ = std::sqrt(std::max(0.0, (radius_ - half) * (radius_ + half)));
  turn_ = cross(a - circle.centre, b - circle.centre) >= 0 ? 1 : -1;
  centre_ = m + (turn_ * height_ / (2 * half)) * left_normal(b - a);
  half_angle_ = std::asin(std::min(1.0, half / radius_));
}

Point ArcOver::at(double share) const {
  if (share <= 0) return a_;
  if (share >= 1) return b_;
  // From the chord: its point below, and how far the arc is from there. Nothing is lost where the
  // circle is large.
  const double angle = (2 * share - 1) * half_angle_;
  const double half = length(b_ - a_) / 2;
  const double along = radius_ * std::sin(angle) / half;  // of half the chord, from its middle
  // cos(angle) - cos(half_angle), without cancellation
  const double height =
      radius_ * 2 * std::sin((half_angle_ + angle) / 2) * std::sin((half_angle_ - angle) / 2);
  const Vector chord = b_ - a_;
  return midpoint(a_, b_) + (along / 2) * chord +
         (-turn_ * height / (2 * half)) * left_normal(chord);
}

Point ArcOver::above(Point p) const { return at(part_on_line(a_, b_, p)); }

Vector ArcOver::from_centre(Point p) const {
  const Vector unit = (1 / length(b_ - a_)) * (b_ - a_);
  return {dot(unit, p - midpoint(a_, b_)), height_ - turn_ * cross(unit, p - a_)};
}

double ArcOver::distance_from_circle(Point p) const {
  // The power of the point over the sum of the two lengths. It is taken from the chord, so that
  // nothing is lost where the circle is large.
  const double sum = length(from_centre(p)) + radius_;
  const double above = -turn_ * cross((1 / length(b_ - a_)) * (b_ - a_), p - a_);
  return std::abs(dot(p - a_, (1 / sum) * (p - b_)) + 2 * (height_ / sum) * above);
}

double ArcOver::rounding_at(Point p) const {
  return kOnCircle * std::max({radius_, std::abs(p.x), std::abs(p.y)});
}

double ArcOver::share_of(Point p) const {
  const Vector to = from_centre(p);
  return 0.5 + std::atan2(to.x, to.y) / (2 * half_angle_);
}

bool ArcOver::cuts_off(Point p) const {
  return turn_ * cross(b_ - a_, p - a_) <= 0 && length(p - centre_) < radius_;
}

std::vector<Point> common_points(const ArcCircle& one, const ArcCircle& other) {
  const Vector between = other.centre - one.centre;
  const double d = length(between);
  if (d == 0) return {};
  // How far the chord that both have in common is from the first one's centre, and half of it.
  const double to_chord = (d + (one.radius - other.radius) * ((one.radius + other.radius) / d)) / 2;
  const double r = one.radius, size = std::max(r, other.radius);
  if (std::abs(to_chord) > r + kOnCircle * size) return {};
  const double half = std::sqrt(std::max(0.0, (r - to_chord) * (r + to_chord)));
  const Vector unit = (1 / d) * between;
  const Point middle = one.centre + to_chord * unit;
  return {middle + half * left_normal(unit), middle + (-half) * left_normal(unit)};
}

bool has_positive_jacobian(const CurvedTriangle& triangle) {
  for (const Point& p : triangle) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
  }
  if (largest_coordinate(triangle) > kOverflow) return has_exactly_positive_jacobian(triangle);
  std::array<LongVector, 3> corner, control;  // control[i]: of the edge from corner i on
  for (std::size_t i = 0; i < 3; ++i) corner[i] = long_vector(triangle[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    const LongVector m = long_vector(triangle[3 + i]);
    const LongVector ends = corner[i] + corner[(i + 1) % 3];
    control[i] =
        m + m - LongVector{{ends.x.high / 2, ends.x.low / 2}, {ends.y.high / 2, ends.y.low / 2}};
  }
  const std::array u{control[0] - corner[0], corner[1] - control[0], control[1] - control[2]};
  const std::array v{control[2] - corner[0], control[1] - control[0], corner[2] - control[2]};
  // Differences of coordinates lose what these lose, not more.
  double place = 0, step = 0;
  for (const auto* points : {&corner, &control}) {
    for (const LongVector& p : *points) place = std::max(place, largest_part(p));
  }
  for (const auto* steps : {&u, &v}) {
    for (const LongVector& s : *steps) step = std::max(step, largest_part(s));
  }
  const double error = std::max(kErrorOfSums * place * step, kUnderflow);
  bool is_open = false;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const DoubleDouble sum = long_cross(u[i], v[j]) + long_cross(u[j], v[i]);
      if (sum.high < -error) return false;
      is_open = is_open || sum.high <= error;
    }
  }
  return !is_open || has_exactly_positive_jacobian(triangle);
}

double area_beside_chord(Point a, Point b, Point m) {
  constexpr double kOfParabola = 2.0 / 3;
  return -kOfParabola * cross(b - a, m - midpoint(a, b));
}

}  // namespace cover
