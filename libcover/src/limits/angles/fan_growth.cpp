// One triangle with the angle phi at the vertex, y opposite to the first edge and z opposite to the
// second makes the ratio sin z / sin y, with z = pi - phi - y. It is the larger the smaller y is,
// so y is the least that the range allows, max(least, pi - phi - most), and the logarithm is
//     g(phi) = ln sin(most) - ln sin(phi + most)     up to phi = pi - most - least, convex,
//     g(phi) = ln sin(phi + least) - ln sin(least)   from there on, concave.
// k triangles of sum f make at most k h(f / k) for any concave h >= g (Jensen): h is the tangent of
// the second part through the start of the first, then the second part. k h(f / k) is concave in k,
// so the best k is found by walking up. Tested by tests/unit/limits/angles/fan_growth_test.cpp.
#include "limits/angles/fan_growth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"

namespace cover {
namespace {

constexpr double kLogSlack = 1e-8;      ///< per triangle: rounding, and the tangent
constexpr double kTangentPoint = 1e-7;  ///< radians: how well that is known
constexpr int kMostSteps = 40;          ///< towards it
constexpr int kMostInFan = 96;  ///< larger fans are not bounded: what they prove is next to nothing

}  // namespace

FanGrowth::FanGrowth(AngleRange range)
    : range_(range), log_sine_most_(std::log(std::sin(range.most))) {
  if (!(range.least > 0)) return;
  log_sine_least_ = std::log(std::sin(range.least));
  peak_ = std::clamp(std::numbers::pi / 2 - range.least, range.least,
                     std::numbers::pi - 2 * range.least);
  const double kink = std::numbers::pi - range.most - range.least;
  peak_ = std::clamp(kink, peak_, std::numbers::pi - 2 * range.least);
  start_ = std::max(0.0, of_one(range.least));
  at_peak_ = of_one(peak_);
  steepest_from_ = range.least;
  if (kink > range.least) {
    steepest_from_ = tangent_point(kink);
    slope_ = (of_one(steepest_from_) - start_) / (steepest_from_ - range.least);
  }
  most_per_radian_ = std::max(start_ / range.least, of_one(steepest_from_) / steepest_from_);
  const double top = std::min(peak_, range.most);
  chord_ = (top - range.least) / kChords;
  for (std::size_t k = 0; k <= kChords; ++k) {
    const bool is_last = k == kChords;
    at_chords_[k] = concave(is_last ? top : range.least + static_cast<double>(k) * chord_);
  }
}

/// Where the slope of the chord from the start is largest, from `kink` to the peak: it grows up to
/// the tangent point and falls after it. Newton's method, within what encloses that point: an error
/// there changes the tangent by its square, but not at the ends, which are exact.
double FanGrowth::tangent_point(double kink) const {
  const auto tangent_above_chord = [this](double at) {
    return (at - range_.least) / std::tan(at + range_.least) - (of_one(at) - start_);
  };
  if (tangent_above_chord(peak_) > 0) return peak_;
  if (!(tangent_above_chord(kink) > 0)) return kink;
  double low = kink, high = peak_, at = (low + high) / 2;
  for (int step = 0; step < kMostSteps && high - low > kTangentPoint; ++step) {
    const double above = tangent_above_chord(at);
    (above > 0 ? low : high) = at;
    const double sine = std::sin(at + range_.least);
    const double change = above * sine * sine / (at - range_.least);
    if (std::abs(change) < kTangentPoint) break;
    at = at + change > low && at + change < high ? at + change : (low + high) / 2;
  }
  return at;
}

double FanGrowth::of_one(double angle) const {
  const double y = std::max(range_.least, std::numbers::pi - angle - range_.most);
  const double z = std::numbers::pi - angle - y;
  if (z < range_.least - kAngleSlack) return -1;
  return std::max(0.0, y > range_.least ? log_sine_most_ - std::log(std::sin(y))
                                        : std::log(std::sin(z)) - log_sine_least_);
}

double FanGrowth::concave(double angle) const {
  if (angle == peak_ && peak_ >= steepest_from_) return at_peak_;
  return angle < steepest_from_ ? start_ + slope_ * (angle - range_.least) : of_one(angle);
}

double FanGrowth::log_ratio(double low, double high, double enough) const {
  if (!(range_.least > 0)) {
    // Thin triangles lead anywhere, if the angle is large enough for one of them.
    if (high >= std::numbers::pi - range_.most - 4 * kAngleSlack) return kInfinity;
    return std::max(0.0, std::log(std::sin(range_.most) / std::sin(high + range_.most))) +
           kLogSlack;
  }
  if (high < range_.least - kAngleSlack) return -1;
  const double least = range_.least;
  const auto value_of = [&](int k) {
    const double from = std::max(low / k, least), to = std::min(high / k, range_.most);
    const double angle = std::clamp(peak_, std::min(from, to), std::max(from, to));
    return k == 1 ? of_one(angle) : k * concave(angle);
  };
  double best = -1;
  // True if that is enough. The slack is that of k + 1, which may be as good but for rounding.
  const auto take = [&](int k, double value) {
    if (value >= 0) best = std::max(best, value + (k + 1) * kLogSlack);
    return best >= enough;
  };
  int fewest = std::max(1, static_cast<int>(std::ceil((low - kAngleSlack) / range_.most)));
  const double room = (high + kAngleSlack) / least;
  int most = room > kMostInFan ? kMostInFan + 1 : std::max(1, static_cast<int>(room));
  if (fewest > most) return best;
  if (fewest == 1 && (take(1, value_of(1)) || most == 1)) return best;
  fewest = std::max(fewest, 2);
  // The best k is where the values stop growing; first near the beginning, where it mostly is.
  for (int step = 4; fewest < most; step *= 4) {
    const int middle = std::min(fewest + step, most) - 1;
    const double value = value_of(middle);
    if (take(middle, value)) return best;
    if (value_of(middle + 1) < value) {
      most = middle;
      break;
    }
    fewest = middle + 1;
  }
  while (fewest < most) {
    const int middle = (fewest + most) / 2;
    const double value = value_of(middle);
    if (take(middle, value)) return best;
    if (value_of(middle + 1) < value) {
      most = middle;
    } else {
      fewest = middle + 1;
    }
  }
  if (fewest > kMostInFan) return kInfinity;
  take(fewest, value_of(fewest));
  return best;
}

/// What as many triangles as fit grow that have the angle that grows most; -1 if none fit.
double FanGrowth::growth_at_peaks(double low, double high) const {
  if (!(range_.least > 0) || peak_ > range_.most) return -1;
  const double k = std::floor(high / peak_);
  if (k < 1 || k > kMostInFan || k * peak_ < low) return -1;
  return k == 1 ? at_peak_ : k * concave(peak_);
}

/// The concave majorant from below, up to its peak.
double FanGrowth::at_chord(double angle) const {
  const double part = (angle - range_.least) / chord_;
  const std::size_t k = std::min(static_cast<std::size_t>(std::max(part, 0.0)), kChords - 1);
  return at_chords_[k] + (part - static_cast<double>(k)) * (at_chords_[k + 1] - at_chords_[k]);
}

/// No more than what some triangles grow that have `high` in sum; -1 if that is not known. Asked of
/// as few of them as keep each below the peak, and of as many as fit: one or the other mostly grows
/// enough, and no logarithm is needed.
double FanGrowth::growth_by_chords(double low, double high) const {
  if (!(chord_ > 0)) return -1;
  const double most = std::min(std::floor(high / range_.least), double{kMostInFan});
  const double fewest = std::max(2.0, std::ceil(high / std::min(peak_, range_.most)));
  if (!(fewest <= most) || !(low <= high)) return -1;
  return std::max(fewest * at_chord(high / fewest), most * at_chord(high / most));
}

/// What no number of triangles exceeds that have `high` in sum: k h(f / k) = f h(x) / x, and h(x) /
/// x is largest at an end of the tangent, since the second part of g goes through zero.
double FanGrowth::most_growth(double high) const {
  if (!(range_.least > 0) || (high + kAngleSlack) / range_.least > kMostInFan) return kInfinity;
  return (high + kAngleSlack) * most_per_radian_ + (kMostInFan + 2) * kLogSlack;
}

bool FanGrowth::may_lead(double low, double high, double ratio) const {
  if (high < range_.least - kAngleSlack) return false;
  if (ratio <= 1) return may_fill(low, high);
  const double most_of_any = most_growth(high);
  if (1 - 1 / ratio > most_of_any) return false;  // a logarithm is no less than that
  // It is no more than what its argument has above one, and mostly this is enough.
  const double at_peaks = growth_at_peaks(low, high);
  if (at_peaks >= ratio - 1) return true;
  const double known = std::max(at_peaks, growth_by_chords(low, high));
  if (known >= ratio - 1) return true;
  const double wanted = std::max(std::log(ratio) - 4 * kAngleSlack, 0.0);
  if (known >= wanted) return true;
  if (wanted > most_of_any) return false;
  return log_ratio(std::max(low, 0.0), high, wanted) >= wanted;
}

/// Whether some number of triangles fills the angle, as isosceles ones do.
bool FanGrowth::may_fill(double low, double high) const {
  return range_.least == 0 || std::floor((high + kAngleSlack) / range_.least) >=
                                  std::ceil((low - kAngleSlack) / range_.most);
}

/// Let phi be the angle at the vertex, y opposite to the other edge and z, the apex, to the side.
/// The side is sin z / sin y = sin z / sin(phi + z) times as long as the edge: this grows with z.
/// With the largest z that phi allows it is largest for y = least and z = 90 degrees, and falls on
/// both sides of that phi; with the smallest z it is smallest for z = apex.least and y = 90
/// degrees. Where no angle may be 90 degrees, the largest one counts. (phi is one that leaves y no
/// more than range.most: where it does not, there is no triangle, and no bound is needed.)
void FanGrowth::find_out_next(Ending& ending) const {
  constexpr double kRight = std::numbers::pi / 2, kRoom = 1 + kLogSlack;
  const AngleRange& apex = ending.apex;
  const auto longer = [&](double phi) {
    const double z = std::min(apex.most, std::numbers::pi - phi - range_.least);
    return kRoom * std::sin(z) / std::sin(phi + z);
  };
  const auto shorter = [&](double phi) {
    const double z = std::max(apex.least, std::numbers::pi - phi - range_.most);
    return kRoom * std::sin(phi + z) / std::sin(z);
  };
  const double longest_at = std::max(kRight, std::numbers::pi - apex.most) - range_.least;
  const double shortest_at = std::max(kRight, std::numbers::pi - range_.most) - apex.least;
  const double part = part_of(apex);
  const double first = range_.least + static_cast<double>(ending.known) * part;
  ending.longer[ending.known] = longer(std::clamp(longest_at, first, first + part));
  ending.shorter[ending.known] = shorter(std::clamp(shortest_at, first, first + part));
  ++ending.known;
}

/// Of the angles at the vertex that the triangle may have.
double FanGrowth::part_of(const AngleRange& apex) const {
  const double most = std::numbers::pi - range_.least - apex.least + kAngleSlack;
  return (most - range_.least) / static_cast<double>(Ending::kParts);
}

bool FanGrowth::may_end(double low, double high, double shortest, double longest,
                        Ending& ending) const {
  const double part = part_of(ending.apex);
  if (!(part >= 0)) return false;
  double first = range_.least;
  for (std::size_t k = 0; k < Ending::kParts && first <= high + kAngleSlack; ++k) {
    const double last = first + part;
    if (k == ending.known) find_out_next(ending);
    // By how much the other triangles must change the length, either way.
    const double ratio = std::max(shortest / ending.longer[k], 1 / (longest * ending.shorter[k]));
    if (ratio <= 1 && low - last <= kAngleSlack) return true;  // there are no others
    if (may_lead(low - last, high - first, ratio)) return true;
    first = last;
  }
  return false;
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
