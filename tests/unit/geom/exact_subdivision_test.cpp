#include "geom/exact_subdivision.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cover {
namespace {

using Parents = std::vector<std::uint32_t>;

std::vector<SubSegment> sorted(std::vector<SubSegment> pieces) {
  std::sort(pieces.begin(), pieces.end(), [](const SubSegment& x, const SubSegment& y) {
    return std::pair(x.left, x.right) < std::pair(y.left, y.right);
  });
  return pieces;
}

TEST(Subdivide, CutsAtCrossingsAndTouches) {
  const std::vector<PlainSegment> cross{{{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}, {{2, 1}, {1, 1}}};
  const auto pieces = sorted(subdivide(cross));
  ASSERT_EQ(pieces.size(), 5U);
  for (const SubSegment& p : pieces)
    EXPECT_TRUE(p.left == (Point{1, 1}) || p.right == (Point{1, 1}));
  EXPECT_EQ(pieces[0].parents, Parents{0});
  EXPECT_EQ(pieces[3].parents, Parents{2});
}

TEST(Subdivide, UnitesOverlaps) {
  const std::vector<PlainSegment> overlap{{{0, 0}, {2, 0}}, {{3, 0}, {1, 0}}, {{1, 0}, {2, 0}}};
  const auto pieces = sorted(subdivide(overlap));
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].parents, Parents{0});
  EXPECT_EQ(pieces[1].parents, (Parents{0, 1, 2}));
  EXPECT_EQ(pieces[2].parents, Parents{1});
}

TEST(Subdivide, RoundsIntersectionsToTheNearestDouble) {
  // The line y = x and the line from (0, 1) to (3, 0) meet at 3/4; y = x and the line from (0, 1)
  // to (2, 0) at 2/3, which is no double.
  const std::vector<PlainSegment> lines{{{0, 0}, {1, 1}}, {{0, 1}, {3, 0}}, {{0, 1}, {2, 0}}};
  const auto pieces = sorted(subdivide(lines));
  const double third = 2.0 / 3;  // division rounds to nearest
  EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(), [&](const SubSegment& p) {
    return p.left == Point{third, third};
  }));
  EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(), [&](const SubSegment& p) {
    return p.left == Point{0.75, 0.75};
  }));
}

}  // namespace
}  // namespace cover
