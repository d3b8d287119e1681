// The wished edge length at every vertex of a region that is being refined.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/point.hpp>

#include "cdt/triangulation.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// h(x): the region's own size, or less near vertices whose size is smaller, from where it grows
/// by (growth - 1) per unit of distance: edges that follow each other then grow by that ratio.
///
/// A boundary vertex has the size given for it; else the mean length of its sides, or the region's
/// size where that is no more than kNear times as long.
class SizeField {
 public:
  /// How much shorter sides may be than the region's size without a graded zone along them.
  static constexpr double kNear = 1.5;

  /// A field without a wish: is_active() is false.
  SizeField() = default;
  /// REQUIRES: `cdt` has the points of `boundary`, maybe in another frame
  /// Cost:     O(n log n)
  SizeField(const RegionBoundary& boundary, const Triangulation& cdt, double growth);

  /// Whether the region has any wish.
  [[nodiscard]] bool is_active() const { return !at_.empty(); }
  /// The size at a vertex.
  [[nodiscard]] double at(std::uint32_t v) const { return at_[v]; }
  /// The size at a distance from a vertex, as far as that vertex has a say.
  [[nodiscard]] double near(std::uint32_t v, double distance) const;
  /// Gives vertex `v`, a new one, its size.
  void set(std::uint32_t v, double size);
  /// The region's own size, infinite if it has none.
  [[nodiscard]] double largest() const { return largest_; }

 private:
  std::vector<double> at_;
  double slope_ = 0;
  double largest_ = 0;
};

}  // namespace cover
