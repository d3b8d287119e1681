#include "io/input/drawings/curves.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "base/numbers.hpp"
#include "geom/turn.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// Even pieces of at most `step`; 1e-9 of one forgives the rounding of `angle / step`.
double pieces(double angle, double step) { return std::max(1.0, std::ceil(angle / step - 1e-9)); }

}  // namespace

double step_for_chord_error(double radius, double chord_error) {
  // The sagitta is r (1 - cos(step / 2)) = 2 r sin^2(step / 4).
  const double sine = std::sqrt(chord_error / (2 * radius));
  return sine >= 0.5 ? 120 : std::min(120.0, 4 * std::asin(sine) / kDegree);
}

Point point_on_circle(Point centre, double radius, double degrees) {
  const double angle = reduced_degrees(degrees);
  const int quadrant = static_cast<int>(angle / 90);
  const double rest = std::fmod(angle, 90);
  // In the first octant sine and cosine are taken as they are, in the second they change roles.
  const bool steep = rest > 45;
  const double small = (steep ? 90 - rest : rest) * kDegree;
  Vector v{std::cos(small), std::sin(small)};
  if (steep) std::swap(v.x, v.y);
  for (int k = 0; k < quadrant; ++k) v = left_normal(v);
  return centre + radius * v;
}

void CurveCutter::add(const Arc& arc) {
  Circle& circle = circles_[{arc.centre.x, arc.centre.y, arc.radius}];
  circle.step = std::min(circle.step, arc.step);
  const Arc& coarsest = circle.coarsest;
  if (arc.chords > 0 && (coarsest.chords == 0 || arc.step > coarsest.step)) circle.coarsest = arc;
  if (!arc.full()) {
    circle.ends.push_back(reduced_degrees(arc.from));
    circle.ends.push_back(reduced_degrees(arc.to));
  } else if (arc.seam() != 0) {  // a plain circle has no ends
    circle.ends.push_back(reduced_degrees(arc.seam()));
  }
}

bool CurveCutter::cut(Circle& circle, std::size_t most) {
  std::vector<double>& ends = circle.ends;
  if (ends.empty()) ends.push_back(0);
  sort_unique(ends);
  double total = 0;
  for (int pass = 0; pass < 2; ++pass) {  // count, then cut
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const double end = i + 1 < ends.size() ? ends[i + 1] : ends[0] + 360;
      const double n = pieces(end - ends[i], circle.step);
      if (pass == 0) total += n;
      for (double k = 0; pass == 1 && k < n; ++k)
        circle.angles.push_back(ends[i] + (end - ends[i]) * k / n);
    }
    if (!(total <= static_cast<double>(most))) return false;
  }
  for (double& angle : circle.angles) angle = reduced_degrees(angle);
  sort_unique(circle.angles);
  return true;
}

std::array<std::size_t, 2> CurveCutter::chords_of(const Circle& circle, const Arc& arc) {
  const std::vector<double>& angles = circle.angles;
  const auto index = [&](double angle) {
    const auto at = std::lower_bound(angles.begin(), angles.end(), reduced_degrees(angle));
    return static_cast<std::size_t>(at - angles.begin()) % angles.size();
  };
  if (arc.full()) return {index(arc.seam()), angles.size()};
  const bool clockwise = arc.to < arc.from;
  const std::size_t first = index(clockwise ? arc.to : arc.from);
  const std::size_t last = index(clockwise ? arc.from : arc.to);
  return {first, (last + angles.size() - first) % angles.size()};
}

std::optional<std::vector<Point>> CurveCutter::points(const Arc& arc, std::size_t most) {
  Circle& circle = circles_.at({arc.centre.x, arc.centre.y, arc.radius});
  if (circle.angles.empty() && !cut(circle, most)) return std::nullopt;

  const std::vector<double>& angles = circle.angles;
  const auto [first, steps] = chords_of(circle, arc);
  if (steps >= most) return std::nullopt;

  std::vector<Point> points;
  points.reserve(steps + 1);
  for (std::size_t k = 0; k <= steps; ++k)
    points.push_back(point_on_circle(arc.centre, arc.radius, angles[(first + k) % angles.size()]));
  if (arc.to < arc.from) std::reverse(points.begin(), points.end());
  return points;
}

std::vector<std::string> CurveCutter::finer_than_asked() const {
  std::vector<std::string> sentences;
  for (const auto& [key, circle] : circles_) {
    const Arc& arc = circle.coarsest;
    // The same number may be divided from another angle, and so be rounded otherwise.
    if (arc.chords == 0 || circle.angles.empty()) continue;
    if (arc.step <= circle.step * (1 + 1e-9)) continue;
    const std::size_t chords = chords_of(circle, arc)[1];
    if (chords <= static_cast<std::size_t>(arc.chords)) continue;
    const bool is_circle = arc.full() && arc.seam() == 0;
    sentences.push_back(fmt::format(
        "the {} around {} of radius {}{} asks for {} and gets {}: curves on one circle share their "
        "points, so the shortest chords count for all of them",
        is_circle ? "circle" : "arc", describe(arc.centre), describe(arc.radius),
        is_circle ? ""
                  : fmt::format(" from {} to {} degrees", describe(arc.from), describe(arc.to)),
        counted(static_cast<std::size_t>(arc.chords), "chord"), chords));
  }
  return sentences;
}

std::uint32_t CircleNumbers::of(const ArcCircle& circle) {
  const auto next = static_cast<std::uint32_t>(circles_.size() + 1);
  const auto [at, is_new] = numbers_.emplace(circle, next);
  if (is_new) circles_.push_back(circle);
  return at->second;
}

double sweep_between(Point a, Point b, Point centre, bool clockwise) {
  const Vector u = a - centre, v = b - centre;
  double sweep = std::atan2(cross(u, v), dot(u, v)) / kDegree;
  if (clockwise) sweep = -sweep;
  if (sweep <= 0) sweep += 360;
  return clockwise ? -sweep : sweep;
}

std::optional<std::vector<Point>> cut_arc_between(Point a, Point b, Point centre, bool clockwise,
                                                  double step, std::size_t most) {
  const bool swapped = b < a;
  if (swapped) {
    std::swap(a, b);
    clockwise = !clockwise;
  }
  const Vector u = a - centre, v = b - centre;
  const double sweep = sweep_between(a, b, centre, clockwise);
  const double n = pieces(std::abs(sweep), step);
  if (!(n < static_cast<double>(most))) return std::nullopt;

  const double start = std::atan2(u.y, u.x) / kDegree;
  std::vector<Point> points{a};
  for (double k = 1; k < n; ++k) {
    const double radius = length(u) + (length(v) - length(u)) * k / n;
    points.push_back(point_on_circle(centre, radius, start + sweep * k / n));
  }
  points.push_back(b);
  if (swapped) std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace cover
