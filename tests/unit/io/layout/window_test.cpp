#include "io/layout/window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace cover {
namespace {

using Points = std::vector<Point>;
constexpr Window kUnit{{0, 0}, {1, 1}};

double area_of(const Points& ring) {
  double twice = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k], b = ring[(k + 1) % ring.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

TEST(ClipPolygon, KeepsWhatIsInsideBitForBit) {
  const Points inside{{0.1, 0.1}, {0.9, 0.2}, {0.3, 1.0 / 3}};
  EXPECT_EQ(clip_polygon(inside, kUnit), inside);
  EXPECT_TRUE(clip_polygon({{2, 0}, {3, 0}, {3, 1}}, kUnit).empty());
  // Beside it, and touching in a side or a corner.
  EXPECT_TRUE(clip_polygon({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, kUnit).empty());
  EXPECT_TRUE(clip_polygon({{1, 1}, {2, 1}, {2, 2}, {1, 2}}, kUnit).empty());
}

TEST(ClipPolygon, CutsAtTheWindow) {
  const Points whole = clip_polygon({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, kUnit);
  EXPECT_EQ(whole.size(), 4U);
  EXPECT_DOUBLE_EQ(area_of(whole), 1);
  // A U whose two arms reach in.
  const Points u{{0.1, 0.5}, {0.1, -2}, {0.9, -2}, {0.9, 0.5},
                 {0.7, 0.5}, {0.7, -1}, {0.3, -1}, {0.3, 0.5}};
  EXPECT_NEAR(std::abs(area_of(clip_polygon(u, kUnit))), 2 * 0.2 * 0.5, 1e-15);
}

TEST(ClipPolygon, NeighboursGetTheSamePoints) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> inside(0.01, 0.99), number(-1, 2);
  int cut = 0;
  for (int run = 0; run < 1000; ++run) {
    const Point a{inside(random), inside(random)}, b{number(random) + 3, number(random)};
    const Points one = clip_polygon({a, b, {inside(random), -1}}, kUnit);
    const Points other = clip_polygon({b, a, {inside(random), 2}}, kUnit);
    std::size_t common = 0;
    for (const Point p : one) {
      EXPECT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1);
      common += static_cast<std::size_t>(std::count(other.begin(), other.end(), p));
    }
    EXPECT_GE(common, 2U) << run;  // where the line a-b starts, and where it leaves
    cut += common == 2 ? 1 : 0;
  }
  EXPECT_GT(cut, 500);
}

TEST(ClipLine, FallsIntoPieces) {
  const auto pieces = clip_line({{-1, 0.5}, {2, 0.5}, {2, 0.75}, {0.5, 0.75}, {0.5, 0.9}}, kUnit);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0], (Points{{0, 0.5}, {1, 0.5}}));
  EXPECT_EQ(pieces[1], (Points{{1, 0.75}, {0.5, 0.75}, {0.5, 0.9}}));
  EXPECT_TRUE(clip_line({{-1, 3}, {2, 3}}, kUnit).empty());
  EXPECT_TRUE(clip_line({{-1, 0.5}, {0.5, 2}}, kUnit).empty());
}

}  // namespace
}  // namespace cover
