#include "disks/gaps/small_polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace cover::disks {
namespace {

TEST(SmallPolygon, FindsTheBestTriangulation) {
  const std::vector<Point> kite{{0, 0}, {2, -1}, {3, 0}, {2, 1}};
  const SmallPolygon polygon(kite);
  ASSERT_EQ(polygon.triangles().size(), 2U);
  double largest = 0;
  for (const auto& [i, j, k] : polygon.triangles()) {
    largest = std::max(largest, largest_angle(kite[i], kite[j], kite[k]));
  }
  EXPECT_EQ(largest, polygon.largest_angle());
  EXPECT_LE(largest, std::numbers::pi / 2);  // by the short diagonal

  const std::vector<Point> bow{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  EXPECT_EQ(SmallPolygon(bow).largest_angle(), kImpossible);
}

}  // namespace
}  // namespace cover::disks
