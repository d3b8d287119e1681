// The lowest point of the maximum of linear functions in the plane, or a step on the way there.
#pragma once

#include <array>
#include <cstddef>

#include "geom/vector.hpp"

namespace cover {

/// Linear functions value + slope . step, by component: several are computed at a time.
class LinearPieces {
 public:
  static constexpr std::size_t kCapacity = 160;

  void clear() { count_ = 0; }
  /// What does not fit is left out: a model, not a promise.
  void add(double value, Vector slope) { add_if(true, value, slope); }
  /// Adds a piece if it `matters`; without a branch, because nobody can predict that.
  void add_if(bool matters, double value, Vector slope) {
    if (count_ == kCapacity) return;
    values_.data()[count_] = value;
    slopes_x_.data()[count_] = slope.x;
    slopes_y_.data()[count_] = slope.y;
    count_ += matters ? 1 : 0;
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] double value(std::size_t k) const { return values_[k]; }
  [[nodiscard]] Vector slope(std::size_t k) const { return {slopes_x_[k], slopes_y_[k]}; }
  [[nodiscard]] double at(std::size_t k, Vector step) const {
    return value(k) + dot(slope(k), step);
  }
  /// The first count() of these are set. Loops over them are vectorized, since no index is checked.
  [[nodiscard]] const double* values() const { return values_.data(); }
  [[nodiscard]] const double* slopes_x() const { return slopes_x_.data(); }
  [[nodiscard]] const double* slopes_y() const { return slopes_y_.data(); }

 private:
  std::array<double, kCapacity> values_, slopes_x_, slopes_y_;
  std::size_t count_ = 0;
};

/// A step, and what the largest piece is there.
struct Descent {
  Vector step;
  double value;
  bool is_cut_short;  ///< by the radius: farther away the pieces would be lower
};

/// Descends on the largest of `pieces` from step 0 until it is at `level`, until the step is as
/// long as `radius`, or until no piece can be lowered without another one rising.
///
/// REQUIRES: at least one piece
/// Cost:     O(pieces) per change of the pieces that tie, of which there are few
Descent descend(const LinearPieces& pieces, double level, double radius);

}  // namespace cover
