#include "almond/arc_meeting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "almond_of.hpp"

namespace cover {
namespace {

using testing::almond_of;

/// The ratio at the end of an arc.
constexpr double kAtTheEnd = std::numeric_limits<double>::infinity();

TEST(Meet, TwoArcsThatCrossTwice) {
  const Almond a = almond_of({0, 0}, {1, 0}, std::numbers::pi / 3),
               b = almond_of({1, 0.4}, {0, 0.4}, std::numbers::pi / 3);
  const std::vector<KnownVertex> known_a{{0, 0}, {1, kAtTheEnd}}, known_b{{2, 0}, {3, kAtTheEnd}};
  const Meetings m = meet(a, known_a, b, known_b);
  ASSERT_EQ(m.count, 2);
  for (const Meeting& x : m.item) {
    EXPECT_NEAR(x.at.y, 0.2, 1e-15);
    EXPECT_NEAR(x.place_a + x.place_b, 1, 1e-14);
    EXPECT_NEAR(a.power(x.at), 0, 1e-15);
    EXPECT_NEAR(b.power(x.at), 0, 1e-15);
  }
  EXPECT_NEAR(m.item[0].at.x + m.item[1].at.x, 1, 1e-14);
}

TEST(Meet, TouchingArcsHaveOnePoint) {
  const double height = almond_of({0, 0}, {1, 0}, std::numbers::pi / 3).height();
  const Almond a = almond_of({0, 0}, {1, 0}, std::numbers::pi / 3);
  const Almond b = almond_of({1, 2 * height}, {0, 2 * height}, std::numbers::pi / 3);
  const std::vector<KnownVertex> known_a{{0, 0}, {1, kAtTheEnd}}, known_b{{2, 0}, {3, kAtTheEnd}};
  const Meetings m = meet(a, known_a, b, known_b);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.item[0].at.x, 0.5, 1e-6);
}

TEST(Meet, ACommonEndGivesTheOtherPointWithoutASquareRoot) {
  // A right corner: the arcs cross once more on its bisector; seen from either side.
  const Almond a = almond_of({0, 0}, {1, 0}, std::numbers::pi / 3);
  Almond b = almond_of({0, 1}, {0, 0}, std::numbers::pi / 3);
  b.u = 2, b.v = 0;
  const std::vector<KnownVertex> known_a{{0, 0}, {1, kAtTheEnd}}, known_b{{2, 0}, {0, kAtTheEnd}};
  for (const Meetings& m : {meet(a, known_a, b, known_b), meet(b, known_b, a, known_a)}) {
    ASSERT_EQ(m.count, 1);
    EXPECT_NEAR(m.item[0].at.x, m.item[0].at.y, 1e-15);
    EXPECT_GT(m.item[0].at.x, 0.1);
  }
}

TEST(Meet, ACommonVertexWhoseRatioHasNoDigitsLeftDoesNotLead) {
  // It is two units in the last place above the start of `a`: its ratio is wrong by a factor.
  const Almond a = almond_of({0, 1}, {0.9, 1.3}, std::numbers::pi / 3);
  const Almond b = almond_of({2, 10}, {0, 1.0000000000000004}, 0);
  for (const double ratio : {1e-17, 2e-16, 5e-16, 1e-15}) {
    const std::vector<KnownVertex> known_a{{0, 0}, {1, kAtTheEnd}, {3, ratio}};
    const std::vector<KnownVertex> known_b{{2, 0}, {3, kAtTheEnd}};
    const Meetings m = meet(a, known_a, b, known_b);
    for (int i = 0; i < m.count; ++i) {
      EXPECT_NEAR(b.power(m.item[static_cast<std::size_t>(i)].at), 0, 1e-5 * b.length * b.length)
          << ratio;
    }
  }
}

TEST(Meet, ArcsTangentAtACommonEndDoNotMeet) {
  // A corner of 120 degrees.
  const Point far{std::cos(2 * std::numbers::pi / 3), std::sin(2 * std::numbers::pi / 3)};
  const Almond a = almond_of({0, 0}, {1, 0}, std::numbers::pi / 3),
               b = almond_of(far, {0, 0}, std::numbers::pi / 3);
  const std::vector<KnownVertex> known_a{{0, 0}, {1, kAtTheEnd}}, known_b{{2, 0}, {0, kAtTheEnd}};
  EXPECT_EQ(meet(a, known_a, b, known_b).count, 0);
}

}  // namespace
}  // namespace cover
