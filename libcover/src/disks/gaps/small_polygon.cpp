// Dynamic programming over diagonals.
// Tested by tests/unit/disks/gaps/small_polygon_test.cpp.
#include "disks/gaps/small_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover::disks {
namespace {

/// Whether the angle at `p` is surely above the one whose cosine is -`sine`: told without an
/// arctangent, which is what a triangulation takes most of its time for.
bool is_surely_above(Point a, Point p, Point b, double sine) {
  const Vector u = a - p, v = b - p;
  const double across = dot(u, v);
  return across < 0 && across * across > sine * sine * squared_length(u) * squared_length(v);
}

}  // namespace

double largest_or_impossible(Point a, Point b, Point c) {
  if (orientation(a, b, c) != Sign::positive) return kImpossible;
  return std::max({angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
}

SmallPolygon::SmallPolygon(std::span<const Point> corners, double most) : size_(corners.size()) {
  constexpr double kRounding = 1e-12;  // of dot products, with room
  const bool is_limited = most < std::numbers::pi;
  const double sine = is_limited ? std::sin(most - std::numbers::pi / 2) + kRounding : 1;
  for (std::size_t span = 2; span < size_; ++span) {
    for (std::size_t i = 0; i + span < size_; ++i) {
      const std::size_t j = i + span;
      cost_[i][j] = kImpossible;
      for (std::size_t k = i + 1; k < j; ++k) {
        const double parts = std::max(cost_[i][k], cost_[k][j]);
        if (parts >= cost_[i][j]) continue;
        const Point a = corners[i], b = corners[k], c = corners[j];
        if (is_limited && (parts > most || is_surely_above(a, b, c, sine) ||
                           is_surely_above(b, c, a, sine) || is_surely_above(c, a, b, sine)))
          continue;
        const double cost = std::max(parts, largest_or_impossible(a, b, c));
        if (cost < cost_[i][j]) cost_[i][j] = cost, apex_[i][j] = static_cast<Index>(k);
      }
    }
  }
}

std::vector<std::array<Index, 3>> SmallPolygon::triangles() const {
  std::vector<std::array<Index, 3>> result;
  std::vector<std::pair<Index, Index>> open{{0, static_cast<Index>(size_ - 1)}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j < i + 2) continue;
    const Index k = apex_[i][j];
    result.push_back({i, k, j});
    open.push_back({i, k});
    open.push_back({k, j});
  }
  return result;
}

}  // namespace cover::disks
