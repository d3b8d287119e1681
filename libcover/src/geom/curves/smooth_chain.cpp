// Unknowns are one point for each side of a pixel, drawn to its middle q by a weight w:
//
//   minimise  sum w |p - q|^2  +  lambda sum |third difference of p|^2
//
// which is a system of three bands beside the diagonal. Where the curve leaves the pixels too far,
// at sharp turns, weights grow and the system is solved again. Straight pieces are found first, by
// least squares in windows from the longest to kShortestStraight sides, and have strong weights.
// Tested by tests/unit/geom/curves/smooth_chain_test.cpp.
#include "geom/curves/smooth_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kPeriodMuch = 40;  ///< waves of this length are halved
constexpr double kPeriodLittle = 10;
constexpr std::size_t kShortestStraight = 64;
/// How far sides of pixels may be from a straight line that they stand for: a half, and something
/// for least squares not being the best line.
constexpr double kStraight = 0.55;
constexpr double kStraightWeight = 30;
constexpr double kFixedWeight = 1e9;
constexpr int kMostRounds = 16;
/// Closed chains are unrolled by this many periods at both ends.
constexpr double kOverlap = 2.5;
/// Chains of so few sides are features of one or two pixels.
constexpr std::size_t kFewSides = 8;
/// A turn between two straight pieces of so many sides each is a corner of what the picture shows,
/// and no part of a curve: of lines and circles, one of two such pieces is a single side or two.
constexpr std::size_t kSharp = 4;
constexpr double kRaise = 2;  ///< of weights, where a curve is too far
/// Points that are too far by less are moved one by one.
constexpr double kPushed = 0.05;
/// Points that are no farther from the curve of the others are left out.
constexpr double kSimple = 0.05;

struct Target {
  Point at;
  double weight = 1;
};

/// Solves the system of the head of this file.
std::vector<Point> solve(const std::vector<Target>& targets, double lambda) {
  const std::size_t n = targets.size();
  std::vector<std::array<double, 4>> band(n, {0, 0, 0, 0});  // A[i][i], A[i][i+1], ...
  for (std::size_t i = 0; i < n; ++i) band[i][0] = targets[i].weight;
  constexpr std::array<double, 4> kThird{-1, 3, -3, 1};
  for (std::size_t r = 0; r + 3 < n; ++r) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i; j < 4; ++j) band[r + i][j - i] += lambda * kThird[i] * kThird[j];
  }
  // A = L D L^T; factor[i][k] is L[i][i-k], factor[i][0] is D[i].
  std::vector<std::array<double, 4>> factor(n, {0, 0, 0, 0});
  std::vector<Point> x(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, 4>& l = factor[i];
    const auto d = [&](std::size_t k) { return factor[i - k][0]; };
    if (i >= 3) l[3] = band[i - 3][3] / d(3);
    if (i >= 2) l[2] = (band[i - 2][2] - (i >= 3 ? l[3] * d(3) * factor[i - 2][1] : 0)) / d(2);
    if (i >= 1) {
      l[1] = (band[i - 1][1] - (i >= 3 ? l[3] * d(3) * factor[i - 1][2] : 0) -
              (i >= 2 ? l[2] * d(2) * factor[i - 1][1] : 0)) /
             d(1);
    }
    l[0] = band[i][0];
    x[i] = {targets[i].weight * targets[i].at.x, targets[i].weight * targets[i].at.y};
    for (std::size_t k = 1; k <= std::min<std::size_t>(3, i); ++k) {
      l[0] -= l[k] * l[k] * d(k);
      x[i] = {x[i].x - l[k] * x[i - k].x, x[i].y - l[k] * x[i - k].y};
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    x[i] = {x[i].x / factor[i][0], x[i].y / factor[i][0]};
    for (std::size_t k = 1; k <= 3 && i + k < n; ++k)
      x[i] = {x[i].x - factor[i + k][k] * x[i + k].x, x[i].y - factor[i + k][k] * x[i + k].y};
  }
  return x;
}

/// A straight line by least squares: a point on it and its direction.
struct Line {
  Point at;
  Vector along;
  [[nodiscard]] double distance(Point p) const { return std::abs(cross(along, p - at)); }
  [[nodiscard]] Point foot(Point p) const { return at + dot(p - at, along) * along; }
};

/// Sums over the first points, for lines through any window in constant time.
class LineSums {
 public:
  explicit LineSums(const std::vector<Target>& targets)
      : sums_(targets.size() + 1), origin_(targets[0].at) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const Vector v = targets[i].at - origin_;
      const auto& before = sums_[i];
      sums_[i + 1] = {before[0] + v.x, before[1] + v.y, before[2] + v.x * v.x,
                      before[3] + v.x * v.y, before[4] + v.y * v.y};
    }
  }
  [[nodiscard]] Line line(std::size_t first, std::size_t last) const {
    const auto n = static_cast<double>(last - first);
    const auto sum = [&](std::size_t k) { return sums_[last][k] - sums_[first][k]; };
    const double x = sum(0) / n, y = sum(1) / n;
    const double xx = sum(2) / n - x * x, xy = sum(3) / n - x * y, yy = sum(4) / n - y * y;
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    return {origin_ + Vector{x, y}, {std::cos(angle), std::sin(angle)}};
  }

 private:
  std::vector<std::array<double, 5>> sums_;
  Point origin_;
};

/// Puts the targets of long straight pieces on lines.
void straighten(std::vector<Target>& targets) {
  const std::size_t n = targets.size();
  if (n < kShortestStraight) return;
  const std::vector<Target> given = targets;
  const LineSums sums(given);
  std::vector<bool> done(n, false);
  std::size_t window = kShortestStraight;
  while (2 * window <= n) window *= 2;
  for (; window >= kShortestStraight; window /= 2) {
    const std::size_t step = window / 4;
    for (std::size_t first = 0; first + window <= n; first += step) {
      if (done[first] && done[first + window - 1]) continue;
      const Line line = sums.line(first, first + window);
      const auto fits = [&](std::size_t i) { return line.distance(given[i].at) <= kStraight; };
      std::size_t low = first, high = first + window;
      bool all = true;
      for (std::size_t i = first; i < high && all; ++i) all = fits(i);
      if (!all) continue;
      while (low > 0 && !done[low - 1] && fits(low - 1)) --low;
      while (high < n && !done[high] && fits(high)) ++high;
      for (std::size_t i = low; i < high; ++i) {
        if (done[i]) continue;
        done[i] = true;
        if (given[i].weight < kFixedWeight) targets[i] = {line.foot(given[i].at), kStraightWeight};
      }
    }
  }
}

double lambda_of(double period) { return std::pow(period / (2 * std::numbers::pi), 6); }

/// How far point k of a curve is from its side, between corners k - 1 and k, and those beside it.
double distance_to_sides(Point p, const std::vector<Point>& corners, std::size_t k) {
  double nearest = kInfinity;
  for (std::size_t j = k > 1 ? k - 2 : 0; j <= k && j + 1 < corners.size(); ++j)
    nearest = std::min(nearest, distance_to_segment(p, corners[j], corners[j + 1]));
  return nearest;
}

bool all_points_near(const std::vector<Point>& curve, const std::vector<Point>& corners) {
  for (std::size_t k = 0; k < curve.size(); ++k)
    if (distance_to_sides(curve[k], corners, k) > kMostMoved) return false;
  return true;
}

/// Point k of the curve stands for the side between corners k - 1 and k (of a chain with ends,
/// point 0 and the last one are its ends). Raises weights where the curve is much too far; false if
/// it is nowhere.
bool raise_weights(const std::vector<Point>& curve, const std::vector<Point>& corners,
                   std::vector<Target>& targets) {
  bool raised = false;
  for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
    const double of_corner = distance_to_segment(corners[k], curve[k], curve[k + 1]);
    const double of_point = distance_to_sides(curve[k], corners, k);
    if (of_corner <= kMostMoved + kPushed && of_point <= kMostMoved) continue;
    raised = true;
    for (Target* target : {&targets[k], &targets[k + 1]})
      if (target->weight < kFixedWeight) target->weight *= kRaise;
  }
  return raised;
}

/// Moves points a little, so that the curve is nowhere too far; false if that does not do. Even
/// straight lines at 45 degrees are 0.707 from some corners of the pixels that stand for them.
bool push_back(std::vector<Point>& curve, const std::vector<Point>& corners,
               const std::vector<Target>& targets) {
  constexpr int kRounds = 8;
  constexpr double kInside = 1e-3;
  for (int round = 0; round < kRounds; ++round) {
    bool pushed = false;
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
      const Vector missed = corners[k] - nearest_on_segment(curve[k], curve[k + 1], corners[k]);
      const double distance = length(missed);
      if (distance <= kMostMoved - kInside / 2) continue;
      pushed = true;
      const Vector push = ((distance - kMostMoved + kInside) / distance) * missed;
      for (const std::size_t i : {k, k + 1})
        if (targets[i].weight < kFixedWeight) curve[i] = curve[i] + push;
    }
    if (!pushed) return true;
  }
  return false;
}

/// The middles of sides, and the ends.
std::vector<Target> middles_of(const std::vector<Point>& corners, bool with_ends) {
  std::vector<Target> targets;
  if (with_ends) targets.push_back({corners.front(), kFixedWeight});
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    targets.push_back({midpoint(corners[k], corners[k + 1]), 1});
  if (with_ends) targets.push_back({corners.back(), kFixedWeight});
  return targets;
}

std::vector<Point> places_of(const std::vector<Target>& targets) {
  std::vector<Point> out;
  out.reserve(targets.size());
  for (const Target& t : targets) out.push_back(t.at);
  return out;
}

/// A straight piece that is no good somewhere is given up there.
void give_up_straight(const std::vector<Target>& middles, std::vector<Target>& targets) {
  for (std::size_t k = 0; k < targets.size(); ++k)
    if (targets[k].weight > 2 * kStraightWeight) targets[k].at = middles[k].at;
}

/// A curve through or near the middles; `corners[k]` lies between points k and k + 1 of it. Empty
/// where no weights keep it near.
std::vector<Point> relaxed(std::vector<Target> targets, const std::vector<Point>& corners,
                           double period, bool straight) {
  const std::vector<Target> middles = targets;
  if (straight) straighten(targets);
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<Point> curve = solve(targets, lambda_of(period));
    if (targets.front().weight >= kFixedWeight) {
      curve.front() = targets.front().at;
      curve.back() = targets.back().at;
    }
    const bool raised = raise_weights(curve, corners, targets);
    if (raised) {
      give_up_straight(middles, targets);
      continue;
    }
    if (push_back(curve, corners, targets) && all_points_near(curve, corners)) return curve;
    return {};
  }
  return {};
}

std::vector<Point> turns_of(const PixelChain& chain) {
  std::vector<Point> out;
  const std::vector<Point>& c = chain.corners;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const bool end = k == 0 || k + 1 == c.size();
    if (end || cross(c[k] - c[k - 1], c[k + 1] - c[k]) != 0) out.push_back(c[k]);
  }
  // A closed chain may begin in the middle of a straight piece.
  if (chain.is_loop && out.size() > 3 &&
      cross(c[1] - c[0], c[c.size() - 1] - c[c.size() - 2]) == 0) {
    out.pop_back();
    out.front() = out.back();
  }
  return out;
}

std::vector<Point> smooth_open(const PixelChain& chain, double period, bool straight) {
  std::vector<Target> targets = middles_of(chain.corners, true);
  if (period == 0 || targets.size() < 5) return places_of(targets);
  return relaxed(std::move(targets), chain.corners, period, straight);
}

std::vector<Point> smooth_closed(const PixelChain& chain, double period, bool straight) {
  const std::size_t n = chain.corners.size() - 1;
  std::vector<Point> curve;
  if (period == 0 || n <= kFewSides) {
    curve = places_of(middles_of(chain.corners, false));
  } else {
    // Unrolled, so that what is at its ends does not reach the middle.
    const auto more = std::max<std::size_t>(static_cast<std::size_t>(kOverlap * period), 4);
    std::vector<Point> corners;
    for (std::size_t k = 0; k <= n + 2 * more; ++k)
      corners.push_back(chain.corners[(k + n * (more / n + 1) - more) % n]);
    std::vector<Target> targets = middles_of(corners, false);
    corners.erase(corners.begin());
    const std::vector<Point> whole = relaxed(std::move(targets), corners, period, straight);
    if (whole.empty()) return {};
    curve.assign(whole.begin() + static_cast<std::ptrdiff_t>(more),
                 whole.begin() + static_cast<std::ptrdiff_t>(more + n));
  }
  curve.push_back(curve.front());
  return curve;
}

/// Leaves points out: none is farther from what stays than kSimple, and no corner than kMostMoved.
/// `corners[k]` lies between points k and k + 1.
std::vector<Point> simplified(const std::vector<Point>& curve, const std::vector<Point>& corners) {
  std::vector<bool> kept(curve.size(), false);
  std::vector<std::pair<std::size_t, std::size_t>> open;
  // A closed curve keeps three points at least.
  const std::size_t parts = curve.front() == curve.back() ? 3 : 1, last = curve.size() - 1;
  for (std::size_t k = 0; k < parts; ++k)
    open.emplace_back(k * last / parts, (k + 1) * last / parts);
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    kept[from] = kept[to] = true;
    double farthest = -1;
    std::size_t at = from;
    bool good = true;
    for (std::size_t k = from; k < to; ++k) {
      good = good && distance_to_segment(corners[k], curve[from], curve[to]) <= kMostMoved;
      const double distance = k > from ? distance_to_segment(curve[k], curve[from], curve[to]) : -1;
      if (distance <= farthest) continue;
      farthest = distance;
      at = k;
    }
    if (at == from || (good && farthest <= kSimple)) continue;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
  std::vector<Point> out;
  for (std::size_t k = 0; k < curve.size(); ++k)
    if (kept[k]) out.push_back(curve[k]);
  return out;
}

/// Where a chain has sharp corners, of a loop that begins at a turn if there is one: indices of its
/// corners, without the ends of a chain that has some.
std::vector<std::size_t> sharp_corners(const PixelChain& chain) {
  const std::vector<Point>& c = chain.corners;
  const std::size_t last = c.size() - 1;
  std::vector<std::size_t> turns{0};
  for (std::size_t k = 1; k < last; ++k) {
    if (cross(c[k] - c[k - 1], c[k + 1] - c[k]) != 0) turns.push_back(k);
  }
  turns.push_back(last);
  const auto is_long = [&](std::size_t t) { return turns[t + 1] - turns[t] >= kSharp; };
  std::vector<std::size_t> sharp;
  if (chain.is_loop && turns.size() > 2 && is_long(0) && is_long(turns.size() - 2))
    sharp.push_back(0);
  for (std::size_t t = 1; t + 1 < turns.size(); ++t) {
    if (is_long(t - 1) && is_long(t)) sharp.push_back(turns[t]);
  }
  return sharp;
}

/// The same loop, from its corner `first` on.
PixelChain begun_at(const PixelChain& loop, std::size_t first) {
  PixelChain out{{}, true};
  const std::size_t n = loop.corners.size() - 1;
  for (std::size_t k = 0; k <= n; ++k) out.corners.push_back(loop.corners[(first + k) % n]);
  return out;
}

/// A loop that begins at a turn, if it has any.
PixelChain begun_at_a_turn(const PixelChain& loop) {
  const std::vector<Point>& c = loop.corners;
  for (std::size_t k = 1; k + 1 < c.size(); ++k) {
    if (cross(c[k] - c[k - 1], c[k + 1] - c[k]) != 0) return begun_at(loop, k);
  }
  return loop;
}

std::vector<Point> smooth_between_corners(const PixelChain& chain, Smoothing smoothing) {
  std::vector<double> periods{0};
  if (smoothing >= Smoothing::little) periods.push_back(kPeriodLittle);
  if (smoothing == Smoothing::much) periods.push_back(kPeriodMuch);
  while (!periods.empty()) {
    const double period = periods.back();
    periods.pop_back();
    const bool straight = period == kPeriodMuch;
    std::vector<Point> curve = chain.is_loop ? smooth_closed(chain, period, straight)
                                             : smooth_open(chain, period, straight);
    if (curve.empty()) continue;
    std::vector<Point> corners = chain.corners;
    if (chain.is_loop) corners.erase(corners.begin());
    return simplified(curve, corners);
  }
  return turns_of(chain);
}

}  // namespace

std::vector<Point> smooth_chain(const PixelChain& chain, Smoothing smoothing) {
  if (smoothing == Smoothing::none) return turns_of(chain);
  PixelChain whole = chain.is_loop ? begun_at_a_turn(chain) : chain;
  std::vector<std::size_t> sharp = sharp_corners(whole);
  if (sharp.empty()) return smooth_between_corners(chain, smoothing);
  if (whole.is_loop) {
    const std::size_t first = sharp.front();
    whole = begun_at(whole, first);
    for (std::size_t& k : sharp) k -= first;
  }
  sharp.push_back(whole.corners.size() - 1);
  std::vector<Point> curve{whole.corners.front()};
  std::size_t from = 0;
  for (const std::size_t to : sharp) {
    if (to == 0) continue;
    const auto begin = whole.corners.begin();
    const PixelChain part{
        {begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to) + 1},
        false};
    const std::vector<Point> smooth = smooth_between_corners(part, smoothing);
    curve.insert(curve.end(), smooth.begin() + 1, smooth.end());
    from = to;
  }
  return curve;
}

}  // namespace cover
