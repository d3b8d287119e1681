#include "box/half_discs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geom/vector.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using namespace testing;

bool are_covered(const Loop& loop, const std::vector<std::size_t>& not_free = {}) {
  const RegionBoundary boundary = boundary_of({loop});
  std::vector<bool> is_free(boundary.sides.size(), true);
  for (const std::size_t v : not_free) {
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      if (boundary.points[boundary.sides[s][0]] == loop[v]) is_free[s] = false;
    }
  }
  return half_discs_cover(boundary.points, boundary.sides, is_free);
}

TEST(HalfDiscs, CoverRectanglesButNotSquares) {
  EXPECT_TRUE(are_covered({{0, 0}, {28, 0}, {28, 1}, {0, 1}}));
  EXPECT_TRUE(are_covered({{0, 0}, {1.1, 0}, {1.1, 1}, {0, 1}}));
  EXPECT_FALSE(are_covered({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));  // the middle is left
}

TEST(HalfDiscs, CoverTrianglesUpToTheRightOne) {
  EXPECT_TRUE(are_covered({{0, 0}, {1, 0}, {0.5, 0.9}}));
  EXPECT_TRUE(are_covered({{0, 0}, {10, 0}, {5, 0.1}}));
}

TEST(HalfDiscs, LeaveTheMiddleOfShortSides) {
  Loop ring;
  for (int k = 0; k < 12; ++k) {
    const double t = k * std::numbers::pi / 6;
    ring.push_back({std::cos(t), std::sin(t)});
  }
  EXPECT_FALSE(are_covered(ring));
  // Both long sides have a vertex in the middle, where their discs touch.
  EXPECT_FALSE(are_covered({{0, 0}, {2, 0}, {4, 0}, {4, 2.1}, {2, 2.1}, {0, 2.1}}));
}

TEST(HalfDiscs, ASideThatIsNotFreeHasToBeCoveredByOthers) {
  const Loop thin{{0, 0}, {28, 0}, {27, 1}, {1, 1}};
  EXPECT_TRUE(are_covered(thin));
  EXPECT_TRUE(are_covered(thin, {3}));  // the slanted one lies in the disc of the longest
  EXPECT_FALSE(are_covered(thin, {0, 2}));
  // Beside a right angle no disc reaches the other side.
  EXPECT_FALSE(are_covered({{0, 0}, {28, 0}, {28, 1}, {0, 1}}, {1}));
}

TEST(HalfDiscs, AreNotLookedAtWhereSomethingMayHideASide) {
  EXPECT_FALSE(are_covered({{0, 0}, {10, 0}, {10, 0.5}, {5, 0.2}, {0, 0.5}}));
  const RegionBoundary ring =
      boundary_of({{{0, 0}, {10, 0}, {10, 1}, {0, 1}}, {{1, 0.4}, {1, 0.6}, {9, 0.6}, {9, 0.4}}});
  EXPECT_FALSE(half_discs_cover(ring.points, ring.sides, std::vector<bool>(8, true)));
}

TEST(HalfDiscs, NoPlaceOfACoveredRegionIsLeft) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi), part(0, 1);
  int covered = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<double> turns(3 + static_cast<std::size_t>(k % 6));
    for (double& t : turns) t = turn(random);
    std::sort(turns.begin(), turns.end());
    const double flat = 0.1 + 0.9 * part(random);
    Loop loop;
    for (const double t : turns) loop.push_back({std::cos(t), flat * std::sin(t)});
    if (!are_covered(loop)) continue;
    ++covered;
    for (int tries = 0; tries < 500; ++tries) {
      const std::size_t i = 1 + random() % (loop.size() - 2);
      double s = part(random), t = part(random);
      if (s + t > 1) s = 1 - s, t = 1 - t;
      const Point p = loop[0] + s * (loop[i] - loop[0]) + t * (loop[i + 1] - loop[0]);
      bool is_in = false;
      for (std::size_t a = 0; a < loop.size() && !is_in; ++a) {
        const std::size_t b = (a + 1) % loop.size();
        is_in = dot(loop[a] - p, loop[b] - p) < 1e-12;
      }
      EXPECT_TRUE(is_in) << k;
    }
  }
  EXPECT_GT(covered, 200);
}

}  // namespace
}  // namespace cover
