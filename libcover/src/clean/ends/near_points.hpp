// Points within a reach of a place. They are sorted into square cells twice as wide, so what is
// near lies in the nine cells around.
// Tested by tests/unit/clean/ends/loose_ends_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// Points by the cell that they lie in.
class NearPoints {
 public:
  /// Those of `points` for whose index `is_wanted` holds.
  ///
  /// REQUIRES: reach > 0
  /// Cost:     O(n log n)
  template <class Test>
  NearPoints(std::span<const Point> points, double reach, Test is_wanted) : width_(2 * reach) {
    for (std::uint32_t v = 0; v < points.size(); ++v) {
      if (is_wanted(v)) entries_.push_back({cell_of(points[v]), v});
    }
    std::sort(entries_.begin(), entries_.end());
  }

  /// Calls visit(v) for all points in the cells around `p`, among them those within the reach.
  ///
  /// Cost: O(log n), and what is found
  template <class Visit>
  void visit(Point p, Visit visit) const {
    const Cell at = cell_of(p);
    for (const double x : {at[0] - 1, at[0], at[0] + 1}) {
      auto entry = std::lower_bound(entries_.begin(), entries_.end(), Entry{{x, at[1] - 1}, 0});
      for (; entry != entries_.end() && entry->cell[0] == x && entry->cell[1] <= at[1] + 1; ++entry)
        visit(entry->vertex);
    }
  }

 private:
  using Cell = std::array<double, 2>;  // whole numbers, that need not fit into an integer
  struct Entry {
    Cell cell;
    std::uint32_t vertex;
    auto operator<=>(const Entry&) const = default;
  };
  [[nodiscard]] Cell cell_of(Point p) const {
    return {std::floor(p.x / width_), std::floor(p.y / width_)};
  }

  double width_;
  std::vector<Entry> entries_;
};

}  // namespace cover
