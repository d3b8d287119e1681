// One triangle with the angle phi at the vertex, y opposite to the first edge and z opposite to the
// second makes the ratio sin z / sin y, with z = pi - phi - y. It is the larger the smaller y is,
// so y is the least that the range allows, max(least, pi - phi - most), and the logarithm is
//     g(phi) = ln sin(most) - ln sin(phi + most)     up to phi = pi - most - least, convex,
//     g(phi) = ln sin(phi + least) - ln sin(least)   from there on, concave.
// k triangles of sum f make at most k h(f / k) for any concave h >= g (Jensen): h is the tangent of
// the second part through the start of the first, then the second part. k h(f / k) is concave in k,
// so the best k is found by walking up. Tested by tests/unit/limits/fan_growth_test.cpp.
#include "limits/fan_growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cover {
namespace {

constexpr double kLogSlack = 1e-8;  ///< per triangle: rounding, and the tangent found by bisection
constexpr int kMostInFan = 96;  ///< larger fans are not bounded: what they prove is next to nothing

}  // namespace

FanGrowth::FanGrowth(AngleRange range) : range_(range) {
  if (!(range.least > 0)) return;
  peak_ = std::clamp(std::numbers::pi / 2 - range.least, range.least,
                     std::numbers::pi - 2 * range.least);
  const double kink = std::numbers::pi - range.most - range.least;
  peak_ = std::clamp(kink, peak_, std::numbers::pi - 2 * range.least);
  start_ = std::max(0.0, of_one(range.least));
  steepest_from_ = range.least;
  if (!(kink > range.least)) return;
  // The slope of the chord from the start grows up to the tangent point and falls after it.
  double low = kink, high = peak_;
  for (int step = 0; step < 40; ++step) {
    const double middle = (low + high) / 2;
    const double rise = of_one(middle) - start_;
    const double tangent = 1 / std::tan(middle + range.least);
    (tangent * (middle - range.least) > rise ? low : high) = middle;
  }
  steepest_from_ = high;
  slope_ = (of_one(high) - start_) / (high - range.least);
}

double FanGrowth::of_one(double angle) const {
  const double y = std::max(range_.least, std::numbers::pi - angle - range_.most);
  const double z = std::numbers::pi - angle - y;
  if (z < range_.least - kAngleSlack) return -1;
  return std::max(0.0, std::log(std::sin(z) / std::sin(y)));
}

double FanGrowth::concave(double angle) const {
  return angle < steepest_from_ ? start_ + slope_ * (angle - range_.least) : of_one(angle);
}

double FanGrowth::log_ratio(double low, double high) const {
  if (!(range_.least > 0)) {
    // Thin triangles lead anywhere, if the angle is large enough for one of them.
    if (high >= std::numbers::pi - range_.most - 4 * kAngleSlack)
      return std::numeric_limits<double>::infinity();
    return std::max(0.0, std::log(std::sin(range_.most) / std::sin(high + range_.most))) +
           kLogSlack;
  }
  if (high < range_.least - kAngleSlack) return -1;
  const double least = range_.least;
  const double room = (high + kAngleSlack) / least;
  const int most_triangles = room > kMostInFan ? kMostInFan + 1 : static_cast<int>(room);
  const int fewest = std::max(1, static_cast<int>(std::ceil((low - kAngleSlack) / range_.most)));
  double best = -1, previous = -1;
  for (int k = fewest; k <= std::max(most_triangles, 1); ++k) {
    if (k > kMostInFan) return std::numeric_limits<double>::infinity();
    const double from = std::max(low / k, least), to = std::min(high / k, range_.most);
    if (from > to + kAngleSlack) continue;
    const double angle = std::clamp(peak_, std::min(from, to), std::max(from, to));
    const double value = k == 1 ? of_one(angle) : k * concave(angle);
    if (value < 0) continue;
    best = std::max(best, value + k * kLogSlack);
    if (k > 1 && value < previous) break;
    if (k > 1) previous = value;
  }
  return best;
}

double FanGrowth::least_reach(double angle) const {
  if (!(range_.least > 0)) return 0;
  const double pieces = std::floor((angle + kAngleSlack) / range_.least) + 1;
  if (pieces > 8) return 0;
  const double one = std::sin(range_.least) /
                     std::sin(std::min(angle / pieces + range_.least, std::numbers::pi / 2));
  return std::pow(one, pieces) * (1 - kLogSlack);
}

}  // namespace cover
