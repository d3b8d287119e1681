// How fast the edges at a vertex can become longer, from one to the next.
#pragma once

#include <array>
#include <cstddef>

#include "base/numbers.hpp"
#include "limits/angles/angle_range.hpp"

namespace cover {

/// Bounds the lengths of the edges around a vertex: triangles side by side, whose angles are all in
/// a range and sum up to `angle` at the vertex, lead from an edge to one that is at most
/// exp(log_ratio(angle, angle)) times as long, and no less than its reciprocal.
class FanGrowth {
 public:
  /// REQUIRES: range.least <= 60 degrees <= range.most
  explicit FanGrowth(AngleRange range);

  /// An upper bound of the logarithm of the ratio, for angles at the vertex from `low` to `high`;
  /// negative if no triangles can have such a sum, infinite if the bound still grows with the 96th
  /// triangle. Where it is `enough` or more, whatever is found first that is.
  ///
  /// Cost: O(1)
  [[nodiscard]] double log_ratio(double low, double high, double enough = kInfinity) const;

  /// Whether triangles side by side, with angles in the range, may lead from an edge to one that is
  /// `ratio` times as long or 1 / ratio, if the angle between is from `low` to `high`.
  ///
  /// REQUIRES: ratio >= 1; kAngleSlack is in low and high
  /// EXACT:    false is a proof
  [[nodiscard]] bool may_lead(double low, double high, double ratio) const;

  /// What the triangle on a side can do where it is the last of a fan, by parts of its angle at the
  /// vertex, from range.least on; found out as it is asked for.
  struct Ending {
    static constexpr std::size_t kParts = 12;
    AngleRange apex;  ///< under which the triangle sees the side from its apex
    std::size_t known = 0;
    std::array<double, kParts> longer{};   ///< the side is no more than so many times as long as
    std::array<double, kParts> shorter{};  ///< its other edge, which is no more than that
  };

  /// As may_lead(), from an edge to a side that is `shortest` to `longest` times as long.
  ///
  /// REQUIRES: range.least > 0; ending.apex within the range; kAngleSlack is in low and high;
  ///           `ending` was given to no other object
  /// EXACT:    false is a proof
  [[nodiscard]] bool may_end(double low, double high, double shortest, double longest,
                             Ending& ending) const;

  /// The least part of the length of the first edge to which its far side can come down within
  /// `angle` of it: a vertex in that direction that is nearer than this lies in a triangle.
  [[nodiscard]] double least_reach(double angle) const;

  [[nodiscard]] AngleRange range() const { return range_; }

 private:
  [[nodiscard]] double of_one(double angle) const;
  void find_out_next(Ending& ending) const;
  [[nodiscard]] double part_of(const AngleRange& apex) const;
  [[nodiscard]] bool may_fill(double low, double high) const;
  [[nodiscard]] double growth_at_peaks(double low, double high) const;
  [[nodiscard]] double growth_by_chords(double low, double high) const;
  [[nodiscard]] double at_chord(double angle) const;
  [[nodiscard]] double most_growth(double high) const;
  [[nodiscard]] double concave(double angle) const;
  [[nodiscard]] double tangent_point(double kink) const;

  AngleRange range_;
  double steepest_from_ = 0;  ///< up to here the concave majorant is a straight line,
  double start_ = 0;          ///< which begins with this at the least angle
  double slope_ = 0;
  double peak_ = 0;     ///< the angle at which one triangle grows most
  double at_peak_ = 0;  ///< so much
  double most_per_radian_ = 0;
  double log_sine_least_ = 0, log_sine_most_ = 0;
  static constexpr std::size_t kChords = 4;
  double chord_ = 0;  ///< the width of equal parts from the least angle to the peak, or the most,
  std::array<double, kChords + 1> at_chords_{};  ///< and the concave majorant at their ends
};

}  // namespace cover
