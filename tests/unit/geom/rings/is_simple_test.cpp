#include "geom/rings/is_simple.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geom/predicates.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

using Ring = std::vector<Point>;

TEST(IsSimple, OrTouchesItself) {
  EXPECT_TRUE(is_simple(Ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_TRUE(is_simple(Ring{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}));   // a point on a side
  EXPECT_FALSE(is_simple(Ring{{0, 0}, {4, 4}, {4, 0}, {0, 4}}));          // crosses
  EXPECT_FALSE(is_simple(Ring{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));  // a corner on a side
  EXPECT_FALSE(is_simple(Ring{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}));  // two corners
  EXPECT_FALSE(is_simple(Ring{{0, 0}, {4, 0}, {6, 0}, {3, 0}, {3, 3}}));          // there and back
}

bool meet(Point a, Point b, Point c, Point d) {
  const auto side = [](Point p, Point q, Point r) {
    return static_cast<int>(orientation(p, q, r));
  };
  const auto is_on = [&](Point p, Point q, Point r) {
    return side(p, q, r) == 0 && std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) &&
           std::min(p.y, q.y) <= r.y && r.y <= std::max(p.y, q.y);
  };
  return (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) ||
         is_on(a, b, c) || is_on(a, b, d) || is_on(c, d, a) || is_on(c, d, b);
}

TEST(IsSimple, AsAllPairsSay) {
  const std::uint64_t seed = testing::test_seed(17);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  int simple = 0;
  for (int round = 0; round < 3000; ++round) {
    // Points of a small lattice, so that corners lie on sides; every second time by angle, so that
    // many are simple.
    const std::size_t n = 4 + random() % 5;
    Ring ring;
    while (ring.size() < n) {
      const Point p{static_cast<double>(random() % 9) - 4, static_cast<double>(random() % 9) - 4};
      if (std::find(ring.begin(), ring.end(), p) == ring.end()) ring.push_back(p);
    }
    if (round % 2 == 0)
      std::sort(ring.begin(), ring.end(), [](Point p, Point q) {
        return std::atan2(p.y + 0.1, p.x + 0.2) < std::atan2(q.y + 0.1, q.x + 0.2);
      });
    bool expected = true;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 2; j < n; ++j) {
        if (i == 0 && j + 1 == n) continue;
        if (meet(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n])) expected = false;
      }
      // Neighbours meet in more than their corner where the line turns back on itself.
      const Point p = ring[i], q = ring[(i + 1) % n], r = ring[(i + 2) % n];
      if (orientation(p, q, r) == Sign::zero &&
          (q.x - p.x) * (r.x - q.x) + (q.y - p.y) * (r.y - q.y) < 0)
        expected = false;
    }
    ASSERT_EQ(is_simple(ring), expected) << "round " << round;
    simple += expected;
  }
  EXPECT_GT(simple, 300);
  EXPECT_LT(simple, 2700);
}

}  // namespace
}  // namespace cover
