// In the space of circles z = (x, y, rho), touching a line from its left is a linear equation and
// touching a disk (c, r) a quadric, |x - c|^2 = (rho + r)^2; all these quadrics have the same
// quadratic part x^2 + y^2 - rho^2, so the difference of two is linear. Two linear rows give a line
// z0 + lambda v; the remaining disk gives a quadratic equation for lambda. One routine covers all
// mixtures of disks and lines.
// Tested by tests/unit/disks/packing/search/apollonius_test.cpp.
#include "disks/packing/search/apollonius.hpp"

#include <cmath>

namespace cover::disks {
namespace {

/// A vector of the space of circles.
struct Vector3 {
  double x = 0, y = 0, r = 0;
};
Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.r + b.r}; }
Vector3 operator*(double s, Vector3 a) { return {s * a.x, s * a.y, s * a.r}; }
double dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.r * b.r; }
/// The Lorentz form, whose null vectors are the differences of touching circles.
double lorentz(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y - a.r * b.r; }
Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.r - a.r * b.y, a.r * b.x - a.x * b.r, a.x * b.y - a.y * b.x};
}

/// The equation a . z = d.
struct Row {
  Vector3 a;
  double d = 0;
};

Row normalised(Row row) {
  const double s = 1 / std::sqrt(dot(row.a, row.a));
  return {s * row.a, s * row.d};
}

Row row_of_line(const Element& e, Vector start) {
  const Vector n = left_normal(e.d);
  return normalised({{n.x, n.y, -1}, cover::dot(n, start)});
}

/// |c|^2 - r^2 without cancellation where the circle passes near the origin.
double power_of_origin(Vector c, double r) {
  const double l = norm(c);
  return (l - r) * (l + r);
}

Row row_of_disks(Vector c, double r, Vector base, double base_r) {
  return normalised({{2 * (c.x - base.x), 2 * (c.y - base.y), 2 * (r - base_r)},
                     power_of_origin(c, r) - power_of_origin(base, base_r)});
}

/// The solution of three rows by Cramer's rule; {0, 0, 0} where they are dependent.
Vector3 solve(const std::array<Row, 3>& rows) {
  const Vector3 bc = cross(rows[1].a, rows[2].a);
  const double det = dot(rows[0].a, bc);
  if (det == 0) return {};
  return (1 / det) * (rows[0].d * bc + rows[1].d * cross(rows[2].a, rows[0].a) +
                      rows[2].d * cross(rows[0].a, rows[1].a));
}

/// One Newton step on the three distances.
Circle polished(const std::array<const Element*, 3>& e, Circle circle) {
  std::array<Row, 3> rows;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector n = e[k]->is_line() ? left_normal(e[k]->d) : outward(*e[k], circle.c);
    rows[k] = {{n.x, n.y, -1}, circle.r - signed_distance(*e[k], circle.c)};
  }
  const Vector3 step = solve(rows);
  if (!(std::abs(step.x) + std::abs(step.y) + std::abs(step.r) < 0.1 * circle.r)) return circle;
  return {circle.c + Vector{step.x, step.y}, circle.r + step.r};
}

/// Real roots of a l^2 + 2 b l + c, without cancellation.
int roots(double a, double b, double c, std::array<double, 2>& out) {
  constexpr double kRelative = 1e-12;  // a double root may come out slightly complex
  constexpr double kLinear = 1e-13;    // below: the other root is not representable anyway
  double disc = b * b - a * c;
  if (disc < 0) {
    if (disc < -kRelative * (b * b + std::abs(a * c))) return 0;
    disc = 0;
  }
  const double q = -(b + std::copysign(std::sqrt(disc), b));
  int count = 0;
  if (q != 0) out[static_cast<std::size_t>(count++)] = c / q;
  if (std::abs(a) > kLinear) out[static_cast<std::size_t>(count++)] = q / a;
  return count;
}

}  // namespace

TangentCircles tangent_circles(const Element& e1, const Element& e2, const Element& e3,
                               Point near) {
  const std::array<const Element*, 3> e{&e1, &e2, &e3};
  TangentCircles result;
  const auto keep = [&](Vector3 z) {
    if (!(z.r > 0)) return;
    const Circle circle = polished(e, {near + Vector{z.x, z.y}, z.r});
    if (circle.r > 0) result.circle[static_cast<std::size_t>(result.count++)] = circle;
  };

  std::array<Row, 3> rows;
  std::size_t count = 0;
  const Element* base = nullptr;
  for (const Element* k : e) {
    if (k->is_line()) {
      rows[count++] = row_of_line(*k, k->c - near);
    } else if (base == nullptr) {
      base = k;
    } else {
      rows[count++] = row_of_disks(k->c - near, k->r, base->c - near, base->r);
    }
  }
  if (base == nullptr) {
    keep(solve(rows));
    return result;
  }
  const double g = dot(rows[0].a, rows[1].a);
  Vector3 v = cross(rows[0].a, rows[1].a);
  const double n = dot(v, v);
  if (n == 0) return result;
  const Vector3 z0 =
      (1 / n) * ((rows[0].d - g * rows[1].d) * rows[0].a + (rows[1].d - g * rows[0].d) * rows[1].a);
  v = (1 / std::sqrt(n)) * v;
  const Vector c = base->c - near;
  const Vector3 p = z0 + Vector3{-c.x, -c.y, base->r};
  std::array<double, 2> lambda{};
  const int k = roots(lorentz(v, v), lorentz(p, v), lorentz(p, p), lambda);
  for (int i = 0; i < k; ++i) keep(z0 + lambda[static_cast<std::size_t>(i)] * v);
  return result;
}

}  // namespace cover::disks
