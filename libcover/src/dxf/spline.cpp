// Evaluation by de Boor's algorithm. Tested by tests/unit/dxf/spline_test.cpp.
#include "dxf/spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <cover/angle.hpp>

#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr std::size_t kMostDegree = 24;
constexpr int kMostHalvings = 12;

/// A point with its weight.
struct Weighted {
  double x = 0, y = 0, w = 0;
};

class SplineCutter {
 public:
  SplineCutter(const DxfSpline& spline, double step, std::optional<double> chord_error)
      : spline_(spline), step_(Angle::degrees(step).in_radians()), chord_error_(chord_error) {}

  std::vector<Point> points() {
    const std::vector<double>& knots = spline_.knots;
    const std::size_t p = spline_.degree;
    for (std::size_t span = p; span + p + 1 < knots.size(); ++span) {
      if (!(knots[span] < knots[span + 1])) continue;
      const Point first = at(span, knots[span]);
      const Point last = at(span, knots[span + 1]);
      if (points_.empty()) points_.push_back(first);
      cut(span, knots[span], first, knots[span + 1], last, p == 1 ? kMostHalvings : 0);
    }
    return std::move(points_);
  }

 private:
  [[nodiscard]] Point at(std::size_t span, double u) const {
    const std::size_t p = spline_.degree;
    std::array<Weighted, kMostDegree + 1> d;
    for (std::size_t j = 0; j <= p; ++j) {
      const std::size_t k = span - p + j;
      const double w = spline_.weights[k];
      d.at(j) = {spline_.controls[k].x * w, spline_.controls[k].y * w, w};
    }
    for (std::size_t r = 1; r <= p; ++r) {
      for (std::size_t j = p; j >= r; --j) {
        const double low = spline_.knots[span - p + j], high = spline_.knots[span + 1 + j - r];
        const double t = high > low ? (u - low) / (high - low) : 0;
        const Weighted a = d.at(j - 1), b = d.at(j);
        d.at(j) = {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y, (1 - t) * a.w + t * b.w};
      }
    }
    return {d.at(p).x / d.at(p).w, d.at(p).y / d.at(p).w};
  }

  static double turn(Point a, Point b, Point c) { return a == b || b == c ? 0 : nu_at(a, b, c); }
  static double off_line(Point p, Point a, Point b) {
    const Vector along = b - a;
    const double size = length(along);
    return size > 0 ? std::abs(cross(along, p - a)) / size : length(p - a);
  }

  /// Adds the points after u0 up to u1.
  void cut(std::size_t span, double u0, Point p0, double u1, Point p1, int halvings) {
    const double um = u0 + (u1 - u0) / 2;
    const Point q1 = at(span, u0 + (u1 - u0) / 4), m = at(span, um);
    const Point q3 = at(span, u0 + 3 * ((u1 - u0) / 4));
    const double turned = turn(p0, q1, m) + turn(q1, m, q3) + turn(m, q3, p1);
    const double off = std::max({off_line(q1, p0, p1), off_line(m, p0, p1), off_line(q3, p0, p1)});
    // Between four chords the curve turns by four thirds of what it does at the three corners.
    const bool good = turned * 4 / 3 <= step_ && (!chord_error_ || off <= *chord_error_);
    if (good || halvings >= kMostHalvings) {
      points_.push_back(p1);
      return;
    }
    cut(span, u0, p0, um, m, halvings + 1);
    cut(span, um, m, u1, p1, halvings + 1);
  }

  const DxfSpline& spline_;
  double step_;
  std::optional<double> chord_error_;
  std::vector<Point> points_;
};

}  // namespace

std::optional<std::vector<Point>> spline_points(const DxfSpline& spline, double step,
                                                std::optional<double> chord_error) {
  const std::size_t n = spline.controls.size();
  const bool whole = spline.degree >= 1 && spline.degree <= kMostDegree && n > spline.degree &&
                     spline.knots.size() == n + spline.degree + 1 &&
                     std::is_sorted(spline.knots.begin(), spline.knots.end());
  std::vector<Point> points = whole    ? SplineCutter(spline, step, chord_error).points()
                              : n == 0 ? spline.fits
                                       : std::vector<Point>();
  if (points.size() < 2) return std::nullopt;
  if (!whole && spline.closed) points.push_back(points.front());
  return points;
}

}  // namespace cover
