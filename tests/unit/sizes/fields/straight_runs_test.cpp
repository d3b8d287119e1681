#include "sizes/fields/straight_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace cover {
namespace {

/// A square of side one whose sides are cut into `pieces`, as doubles can hold that.
Outline cut_square(std::uint32_t pieces) {
  Outline outline;
  const std::array<Point, 4> corners{{{0.1, 0.2}, {1.1, 0.3}, {1.0, 1.3}, {0.0, 1.2}}};
  for (std::uint32_t side = 0; side < 4; ++side) {
    const Point a = corners[side], b = corners[(side + 1) % 4];
    for (std::uint32_t k = 0; k < pieces; ++k) {
      const double part = k / static_cast<double>(pieces);
      outline.points.push_back({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)});
    }
  }
  const auto n = static_cast<std::uint32_t>(outline.points.size());
  for (std::uint32_t v = 0; v < n; ++v) outline.sides.push_back({v, (v + 1) % n});
  return outline;
}

Outline joined(const Outline& outline, double tolerance = 1e-9) {
  return with_straight_runs_joined(outline.points, outline.sides, tolerance);
}

TEST(StraightRuns, CutsOfASquareGo) {
  const Outline square = joined(cut_square(1'000));
  EXPECT_EQ(square.points, cut_square(1).points);
  EXPECT_EQ(square.sides, cut_square(1).sides);
}

TEST(StraightRuns, WhereTheWalkBeginsAVertexMayStay) {
  Outline square = cut_square(10);
  std::rotate(square.sides.begin(), square.sides.begin() + 5, square.sides.end());
  EXPECT_EQ(joined(square).points.size(), 5U);
}

TEST(StraightRuns, ACircleStaysWithinTheTolerance) {
  constexpr std::uint32_t kPoints = 10'000;
  constexpr double kTolerance = 1e-4;
  Outline circle;
  for (std::uint32_t k = 0; k < kPoints; ++k) {
    const double angle = 2 * std::numbers::pi * k / kPoints;
    circle.points.push_back({std::cos(angle), std::sin(angle)});
    circle.sides.push_back({k, (k + 1) % kPoints});
  }
  EXPECT_EQ(joined(circle).points.size(), kPoints);
  const Outline rough = joined(circle, kTolerance);
  EXPECT_LT(rough.points.size(), 400U);
  for (const auto& [a, b] : rough.sides) {
    const Point p = rough.points[a], q = rough.points[b];
    EXPECT_GT(std::hypot((p.x + q.x) / 2, (p.y + q.y) / 2), 1 - 1.01 * kTolerance);
  }
}

TEST(StraightRuns, WhereSeveralSidesMeetNothingIsJoined) {
  // A slit from the middle of the lower side, cut itself, and a point on no side.
  const Outline slit{{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}, {2, 2}, {3, 3}},
                     {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {1, 5}, {5, 6}, {6, 5}, {5, 1}}};
  const Outline same = joined(slit);
  EXPECT_EQ(same.points, slit.points);
  EXPECT_EQ(same.sides.size(), slit.sides.size());
}

TEST(StraightRuns, ARunThatTurnsBackEndsThere) {
  const Outline back{{{0, 0}, {1, 0}, {2, 0}, {1.5, 1e-12}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
  const Outline two = joined(back);
  EXPECT_EQ(two.points, (std::vector<Point>{{0, 0}, {2, 0}}));
}

}  // namespace
}  // namespace cover
