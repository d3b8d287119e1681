// How long edges along a segment should be.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <cover/options.hpp>

#include "region/region_boundary.hpp"

namespace cover {

/// A segment, and the edge lengths wished at its ends and along it.
class SegmentSizes {
 public:
  SegmentSizes(Point a, Point b, const Options& options)
      : a_(std::min(a, b)), b_(std::max(a, b)), reversed_(b < a), options_(&options) {}

  /// Adds the wishes of a region for its side `s`, this segment. The region's function is asked
  /// later.
  ///
  /// REQUIRES: `boundary` outlives this
  void add(const RegionBoundary& boundary, std::size_t s);

  /// Whether the segment should be more than one edge: it is 1.5 times as long as wished.
  [[nodiscard]] bool is_long() const { return steps(kLong).count > kLong; }
  /// The edge length wished at a part of the way from the end that comes first in the plane;
  /// infinite where none is.
  [[nodiscard]] double wished_at(double part) const;
  /// Where to cut it; at most a million pieces. From a to b; the same points from b to a.
  [[nodiscard]] std::vector<Point> cuts() const;

 private:
  static constexpr double kLong = 1.5;

  /// Places along the segment, as parts of it, one wished edge apart.
  struct Steps {
    std::vector<double> places{0};
    double count = 0;  ///< of edges up to the end, not whole
  };

  [[nodiscard]] bool has_wish() const;
  /// All of them, or as many as are more than `enough`.
  [[nodiscard]] Steps steps(double enough) const;

  Point a_, b_;  ///< in their order in the plane
  bool reversed_;
  const Options* options_;
  std::array<const SizeFunction*, 2> functions_{};  ///< of the regions beside it
  double along_ = 0;  ///< smallest of the regions and lines; 0: none. As the others
  double at_a_ = 0, at_b_ = 0;
};

}  // namespace cover
