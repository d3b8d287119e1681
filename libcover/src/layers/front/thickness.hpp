// How thick layers are.
#pragma once

#include <vector>

#include <cover/options.hpp>

namespace cover::layers {

/// Whether two rules are for the same layers, wherever these lie.
inline bool lays_the_same(const LayerRule& a, const LayerRule& b) {
  return a.first == b.first && a.growth == b.growth && a.count == b.count;
}

/// The thickness of row after row: the first, then each times the growth.
class Thickness {
 public:
  /// Rows are counted up to LayerRule::count, else up to kMostRows, and no further than `room`.
  Thickness(const LayerRule& rule, double room);

  static constexpr int kMostRows = 1000;

  [[nodiscard]] int rows() const { return static_cast<int>(totals_.size()) - 1; }
  /// Of the first `rows` together.
  ///
  /// REQUIRES: rows <= rows()
  [[nodiscard]] double total(int rows) const { return totals_[static_cast<std::size_t>(rows)]; }
  /// Of the row that follows `rows` others.
  [[nodiscard]] double layer(int rows) const { return layers_[static_cast<std::size_t>(rows)]; }

 private:
  std::vector<double> totals_{0};
  std::vector<double> layers_;
};

}  // namespace cover::layers
