#include "geom/subdivision/sweep_point.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

TEST(SweepPoint, KnowsWhetherItIsADouble) {
  const PlainSegment rising{{0, 0}, {4, 4}};
  EXPECT_TRUE(SweepPoint(rising, {{0, 2}, {4, 2}}).is_double());
  EXPECT_TRUE(SweepPoint(rising, {{0, 3}, {3, 0}}).is_double());
  const SweepPoint third(rising, {{0, 1}, {2, 0}});
  EXPECT_FALSE(third.is_double());
  EXPECT_EQ(third.rounded(), (Point{2.0 / 3, 2.0 / 3}));
}

TEST(SweepPoint, TellsPointsThatRoundToTheSameDouble) {
  // Both cross the first line between 2/3 and the doubles next to it.
  const PlainSegment rising{{0, 0}, {4, 4}};
  const SweepPoint p(rising, {{0, 1}, {2, 0}}), q(rising, {{0, 1}, {2, 0x1p-56}});
  ASSERT_EQ(p.rounded(), q.rounded());
  EXPECT_EQ(compare(p, q), Sign::negative);
  EXPECT_EQ(compare(q, p), Sign::positive);
  EXPECT_EQ(compare(p, SweepPoint({{0, 1}, {4, -1}}, rising)), Sign::zero);
  EXPECT_EQ(p.side_of(rising.b, rising.a), Sign::zero);
  EXPECT_EQ(q.side_of({0, 1}, {2, 0}), Sign::positive);
  EXPECT_EQ(q.side_of({2, 0}, {0, 1}), Sign::negative);
  EXPECT_EQ(p.compare_distances({0, 0}, {4, 4}), Sign::negative);
  EXPECT_EQ(p.compare_distances({2, 0}, {0, 2}), Sign::zero);
}

/// A crossing of nearly parallel lines is where it is however far its filter fails.
TEST(SweepPoint, RoundsTheSameWayFromBothSidesAtAnyScale) {
  std::mt19937_64 random(testing::test_seed(41));
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int k = 0; k < 2000; ++k) {
    const double miss = std::ldexp(1.0, -k % 60);
    const auto end = [&](double x) { return Point{x, miss * uniform(random)}; };
    PlainSegment s{end(-1), end(1)}, t{end(-1), end(1)};
    if ((s.a.y < t.a.y) == (s.b.y < t.b.y)) std::swap(s.b.y, t.b.y);
    if ((s.a.y < t.a.y) == (s.b.y < t.b.y) || s.a.y == t.a.y || s.b.y == t.b.y) continue;
    const SweepPoint p(s, t), q({t.b, t.a}, s);
    ASSERT_EQ(p.rounded(), q.rounded());
    ASSERT_EQ(compare(p, q), Sign::zero);
    ASSERT_EQ(p.side_of(s.a, s.b), Sign::zero);
    ASSERT_EQ(p.side_of(t.b, t.a), Sign::zero);
    const auto scaled = [](const PlainSegment& line, double f) -> PlainSegment {
      return {{f * line.a.x, f * line.a.y}, {f * line.b.x, f * line.b.y}};
    };
    const Point up = SweepPoint(scaled(s, 0x1p30), scaled(t, 0x1p30)).rounded();
    ASSERT_EQ(up, (Point{0x1p30 * p.rounded().x, 0x1p30 * p.rounded().y}));
  }
}

}  // namespace
}  // namespace cover
