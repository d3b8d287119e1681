// Steepest descent on a piecewise linear convex function. Its direction is the shortest vector in
// the convex hull of the slopes that tie for the largest value, turned round: each of them then
// falls at least as fast as the square of its length. At most three slopes matter in the plane, and
// where they enclose zero is the minimum. Tested by tests/unit/quality/optimum/minimax_test.cpp.
#include "quality/optimum/minimax.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace cover {
namespace {

constexpr int kPivots = 12;      ///< at most; three to five are common
constexpr double kFlat = 1e-12;  ///< squared, times the steepest: a slope that is none
constexpr double kNever = kInfinity;

/// Up to three pieces that tie for the largest value.
struct Tie {
  std::array<std::size_t, 3> pieces{};
  std::size_t count = 0;
};

/// The point of the segment from `a` to `b` that is nearest to zero; `share` is that of b in it.
Vector nearest_to_zero(Vector a, Vector b, double& share) {
  const Vector along = b - a;
  const double size = squared_length(along);
  share = size > 0 ? std::min(1.0, std::max(0.0, -dot(a, along) / size)) : 0;
  return a + share * along;
}

/// The shortest vector in the convex hull of the tying slopes. Pieces that it does not need leave
/// the tie: they fall faster.
Vector shortest_slope(const LinearPieces& pieces, Tie& tie) {
  const auto slope = [&](std::size_t k) { return pieces.slope(tie.pieces[k]); };
  if (tie.count == 1) return slope(0);
  if (tie.count == 3) {
    const double a = cross(slope(0), slope(1)), b = cross(slope(1), slope(2)),
                 c = cross(slope(2), slope(0));
    if ((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0)) return {};
  }
  Vector shortest;
  double least = kInfinity;
  Tie needed;
  for (std::size_t i = 0; i < tie.count; ++i) {
    for (std::size_t j = i + 1; j < tie.count; ++j) {
      double share = 0;
      const Vector v = nearest_to_zero(slope(i), slope(j), share);
      if (!(squared_length(v) < least)) continue;
      shortest = v;
      least = squared_length(v);
      needed.count = 0;
      if (share < 1) needed.pieces[needed.count++] = tie.pieces[i];
      if (share > 0) needed.pieces[needed.count++] = tie.pieces[j];
    }
  }
  tie = needed;
  return shortest;
}

/// How often `along` can be added to `step` until that is as long as `radius`.
double times_within(Vector step, Vector along, double radius) {
  const double a = squared_length(along), b = dot(step, along);
  const double c = squared_length(step) - radius * radius;
  return c < 0 ? (std::sqrt(b * b - a * c) - b) / a : 0;
}

using Times = std::array<double, LinearPieces::kCapacity>;

/// How often `slope`, with squared length `rate`, can be taken off the step of `from` until each
/// piece ties with the largest; infinite for those that fall as fast.
void find_times_until_ties(const LinearPieces& pieces, const Descent& from, Vector slope,
                           double rate, double* times) {
  const double* const values = pieces.values();
  const double* const slopes_x = pieces.slopes_x();
  const double* const slopes_y = pieces.slopes_y();
  const std::size_t count = pieces.count();
  for (std::size_t k = 0; k < count; ++k) {
    const double closing = rate - (slopes_x[k] * slope.x + slopes_y[k] * slope.y);
    const double here = values[k] + (slopes_x[k] * from.step.x + slopes_y[k] * from.step.y);
    const double below = from.value - here;
    const double until = (below < 0 ? 0 : below) / closing;
    times[k] = closing > 0 ? until : kNever;
  }
}

/// The first of `count` times that is the least of them, if that is below `most`; else `count`.
///
/// The least time alone, and then its place, take no move between registers of numbers and of
/// places for each time: a quarter of all of descend().
std::size_t first_of_least(const double* times, std::size_t count, double most) {
  double least = most;
  for (std::size_t k = 0; k < count; ++k) least = times[k] < least ? times[k] : least;
  if (!(least < most)) return count;
  std::size_t first = 0;
  while (times[first] != least) ++first;
  return first;
}

/// The first piece with the largest value.
std::size_t largest_piece(const LinearPieces& pieces) {
  const double* const values = pieces.values();
  std::size_t largest = 0;
  for (std::size_t k = 1; k < pieces.count(); ++k) {
    if (values[k] > values[largest]) largest = k;
  }
  return largest;
}

/// The squared length of the steepest slope.
double steepest_slope(const LinearPieces& pieces) {
  const double* const x = pieces.slopes_x();
  const double* const y = pieces.slopes_y();
  double steepest = 0;
  for (std::size_t k = 0; k < pieces.count(); ++k) {
    const double size = x[k] * x[k] + y[k] * y[k];
    steepest = steepest < size ? size : steepest;
  }
  return steepest;
}

}  // namespace

Descent descend(const LinearPieces& pieces, double level, double radius) {
  Tie tie;
  tie.count = 1;
  tie.pieces[0] = largest_piece(pieces);
  const double steepest = steepest_slope(pieces);
  Descent result{{}, pieces.value(tie.pieces[0]), false};
  Times until;
  for (int pivot = 0; pivot < kPivots && result.value > level; ++pivot) {
    const Vector slope = shortest_slope(pieces, tie);
    const double rate = squared_length(slope);
    if (!(rate > kFlat * steepest)) break;
    // As far as the level, the first piece that ties, or the radius.
    find_times_until_ties(pieces, result, slope, rate, until.data());
    for (std::size_t k = 0; k < tie.count; ++k) until[tie.pieces[k]] = kNever;
    double times = (result.value - level) / rate;
    std::size_t joins = first_of_least(until.data(), pieces.count(), times);
    if (joins < pieces.count()) times = until[joins];
    Vector step = result.step - times * slope;
    if (!(squared_length(step) <= radius * radius)) {
      times = times_within(result.step, -1.0 * slope, radius);
      step = result.step - times * slope;
      joins = pieces.count();
      result.is_cut_short = true;
    }
    result.step = step;
    result.value -= times * rate;
    if (joins == pieces.count()) break;
    tie.pieces[tie.count++] = joins;
  }
  return result;
}

}  // namespace cover
