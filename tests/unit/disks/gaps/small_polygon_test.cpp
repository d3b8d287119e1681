#include "disks/gaps/small_polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace cover::disks {
namespace {

TEST(SmallPolygon, FindsTheBestTriangulation) {
  const std::vector<Point> kite{{0, 0}, {2, -1}, {3, 0}, {2, 1}};
  const SmallPolygon polygon(kite);
  ASSERT_EQ(polygon.triangles().size(), 2U);
  double largest = 0;
  for (const auto& [i, j, k] : polygon.triangles()) {
    largest = std::max(largest, largest_or_impossible(kite[i], kite[j], kite[k]));
  }
  EXPECT_EQ(largest, polygon.largest_angle());
  EXPECT_LE(largest, std::numbers::pi / 2);  // by the short diagonal

  const std::vector<Point> bow{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  EXPECT_EQ(SmallPolygon(bow).largest_angle(), kImpossible);
}

TEST(SmallPolygon, ALimitLeavesOutOnlyWhatIsAboveIt) {
  constexpr double kLimit = std::numbers::pi / 2 + 1e-6;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> step(-0.4, 0.4);
  int within = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Point> corners;
    const int n = 3 + trial % 5;
    for (int k = 0; k < n; ++k) {
      const double t = 2 * std::numbers::pi * (k + step(random)) / n;
      corners.push_back({std::cos(t), std::sin(t)});
    }
    if (trial % 3 == 0) corners = {{0, 0}, {2, 0}, {2, 1 + trial * 1e-9}, {0, 1}};  // right angles
    const SmallPolygon all(corners), limited(corners, kLimit);
    if (all.largest_angle() > kLimit) {
      EXPECT_EQ(limited.largest_angle(), kImpossible);
      continue;
    }
    ++within;
    EXPECT_EQ(limited.largest_angle(), all.largest_angle());
    EXPECT_EQ(limited.triangles(), all.triangles());
  }
  EXPECT_GT(within, 700);
}

}  // namespace
}  // namespace cover::disks
