#include "disks/packing/search/apollonius.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/inputs/shapes.hpp"

namespace cover::disks {
namespace {

TEST(Apollonius, FindsACircleThatTouchesThreeElements) {
  const std::uint64_t seed = testing::test_seed(1);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int k = 0; k < 4000; ++k) {
    // A circle, and three elements that touch it from outside in well separated points.
    const Circle wanted{{uniform(random), uniform(random)}, 0.1 + uniform(random)};
    std::array<Element, 3> e;
    std::array<Point, 3> t;
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = kFullTurn * (static_cast<double>(i) + 0.7 * uniform(random)) / 3;
      const Vector out{std::cos(angle), std::sin(angle)};
      t[i] = wanted.c + wanted.r * out;
      if ((k >> i & 1) != 0) {
        const double r = std::exp(8 * uniform(random) - 5);
        e[i] = make_disk(t[i] + r * out, r, 0);
      } else {
        e[i] = make_line(t[i] + (-1.0) * left_normal(out), t[i] + left_normal(out), 0);
        ASSERT_GT(signed_distance(e[i], wanted.c), 0);
      }
    }
    const TangentCircles found = tangent_circles(e[0], e[1], e[2], t[0]);
    double best = 1;
    for (int i = 0; i < found.count; ++i) {
      const Circle c = found.circle[static_cast<std::size_t>(i)];
      for (const Element& element : e) {
        EXPECT_NEAR(signed_distance(element, c.c), c.r, 1e-12 * (c.r + element.r + 1));
      }
      best = std::min(best, norm(c.c - wanted.c) + std::abs(c.r - wanted.r));
    }
    ASSERT_LT(best, 1e-9) << "lines and disks by the bits of " << k;
  }
}

TEST(Apollonius, GivesNothingForParallelLinesWithoutRoom) {
  const Element up = make_line({0, 0}, {0, 1}, 0), down = make_line({-1, 1}, {-1, 0}, 1);
  const Element between = make_disk({-0.5, 0}, 0.6, 0);  // overlaps both: the circles pass it by
  const TangentCircles found = tangent_circles(up, down, between, {0, 0});
  for (int i = 0; i < found.count; ++i) {
    EXPECT_GT(found.circle[static_cast<std::size_t>(i)].r, 0);
  }
}

TEST(Elements, ContactsAndDistances) {
  const Element disk = make_disk({1, 2}, 0.5, 7);
  EXPECT_DOUBLE_EQ(signed_distance(disk, {1, 4}), 1.5);
  EXPECT_EQ(contact(disk, {1, 4}), (Point{1, 2.5}));
  Element line = make_line({0, 0}, {4, 0}, 3);
  line.from = 1;
  line.to = 3;
  EXPECT_DOUBLE_EQ(signed_distance(line, {2, -1}), -1);
  EXPECT_DOUBLE_EQ(obstacle_distance(line, {2, -1}), 1);
  EXPECT_TRUE(std::isinf(obstacle_distance(line, {0.5, 1})));
  EXPECT_DOUBLE_EQ(way_back(line, {3, 0}, {1, 0}), 2);
  EXPECT_DOUBLE_EQ(way_back(disk, {1.5, 2}, {1, 2.5}), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(ccw_angle({1, 0}, {0, -1}), 1.5 * std::numbers::pi);
}

}  // namespace
}  // namespace cover::disks
