// The rule by which a search keeps a change: one case for each of its lines.
#include "quality/fault/standing.hpp"

#include <gtest/gtest.h>

#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

constexpr double kHalfAPercent = 0.995, kTwoPercent = 0.98;  ///< what is left of an excess

/// Three large angles, one of them above 120 degrees, four small ones, two negative couplings.
GoalStanding middling() { return {0.8, 0.6, 3, 1, 0.5, 4, 2}; }

/// middling(), changed.
template <class Change>
GoalStanding middling_but(Change change) {
  GoalStanding standing = middling();
  change(standing);
  return standing;
}

TEST(Gain, NothingIsNone) { EXPECT_FALSE(is_gain(middling(), middling())); }

TEST(Gain, FewerNegativeCouplingsWinWhateverSmallAnglesPay) {
  const GoalStanding fewer = middling_but([](GoalStanding& s) {
    s.negative = 1;
    s.small = 5;
    s.below = 40;
  });
  EXPECT_TRUE(is_gain(fewer, middling()));
  EXPECT_FALSE(is_gain(middling(), fewer)) << "more of them lose, whatever small angles win";
}

TEST(Gain, MoreNegativeCouplingsLoseWhateverLargeAnglesWin) {
  EXPECT_FALSE(is_gain({0, 0, 0, 0, 0, 0, 3}, middling()));
}

TEST(Gain, FewerNegativeCouplingsDoNotPayForALargeAngle) {
  EXPECT_FALSE(is_gain(middling_but([](GoalStanding& s) {
                         s.negative = 0;
                         s.large = 0.61;
                       }),
                       middling()));
}

TEST(Gain, NothingOfLargeAnglesMayBeWorse) {
  // Each is worse alone, while all the others are better.
  const auto all_better = [](GoalStanding& s) { s = {0.7, 0.3, 1, 0, 0.1, 1, 2}; };
  const auto with = [&](auto change) {
    return middling_but([&](GoalStanding& s) {
      all_better(s);
      change(s);
    });
  };
  ASSERT_TRUE(is_gain(with([](GoalStanding&) {}), middling()));
  EXPECT_FALSE(is_gain(with([](GoalStanding& s) { s.largest = 0.81; }), middling()));
  EXPECT_FALSE(is_gain(with([](GoalStanding& s) { s.large = 0.61; }), middling()));
  EXPECT_FALSE(is_gain(with([](GoalStanding& s) { s.above = 4; }), middling()))
      << "a smaller excess does not pay for one triangle more";
  EXPECT_FALSE(is_gain(with([](GoalStanding& s) { s.far_above = 2; }), middling()));
}

TEST(Gain, OneLargeAngleFewerWinsWhateverSmallOnesPay) {
  const auto paid = [](GoalStanding& s) {
    s.small = 5;
    s.below = 40;
  };
  EXPECT_TRUE(is_gain(middling_but([&](GoalStanding& s) {
                        paid(s);
                        s.above = 2;
                      }),
                      middling()));
  EXPECT_TRUE(is_gain(middling_but([&](GoalStanding& s) {
                        paid(s);
                        s.far_above = 0;
                      }),
                      middling()));
  EXPECT_TRUE(is_gain(middling_but([&](GoalStanding& s) {
                        paid(s);
                        s.large *= kTwoPercent;
                      }),
                      middling()));
}

TEST(Gain, HalfAPercentOfAnExcessIsNoneTwoAre) {
  const auto large = [](double part) {
    return middling_but([&](GoalStanding& s) { s.large *= part; });
  };
  EXPECT_FALSE(is_gain(large(kHalfAPercent), middling()));
  EXPECT_TRUE(is_gain(large(kTwoPercent), middling()));
  const auto small = [](double part) {
    return middling_but([&](GoalStanding& s) { s.small *= part; });
  };
  EXPECT_FALSE(is_gain(small(kHalfAPercent), middling()));
  EXPECT_TRUE(is_gain(small(kTwoPercent), middling()));
}

TEST(Gain, ASmallerLargestAngleAloneIsNone) {
  EXPECT_FALSE(is_gain(middling_but([](GoalStanding& s) { s.largest = 0.4; }), middling()));
}

TEST(Gain, LargeAnglesNeverPayForSmallOnes) {
  // Hardly larger: it is worse by far less than the one in a hundred that would count as better.
  EXPECT_FALSE(is_gain(middling_but([](GoalStanding& s) {
                         s.large *= 1.0001;
                         s.small = 0;
                         s.below = 0;
                       }),
                       middling()));
}

TEST(Gain, OfSmallAnglesNeitherExcessNorCountPaysForTheOther) {
  EXPECT_TRUE(is_gain(middling_but([](GoalStanding& s) { s.below = 3; }), middling()));
  EXPECT_FALSE(is_gain(middling_but([](GoalStanding& s) {
                         s.below = 3;
                         s.small = 0.51;
                       }),
                       middling()));
  EXPECT_FALSE(is_gain(middling_but([](GoalStanding& s) {
                         s.below = 5;
                         s.small = 0.1;
                       }),
                       middling()));
}

TEST(Standing, OfAFanCountsWhatMissesTheGoalGiven) {
  const MutableMesh fan = cdt_mesh(boundary_of({regular_polygon(20, 1, {0, 0})}));
  const Goal goal = default_goal();
  const GoalStanding standing = standing_of(fan, goal);
  EXPECT_GT(standing.above, 0u);
  EXPECT_GT(standing.below, 0u) << "an ear has two angles of 9 degrees";
  EXPECT_GT(standing.large, 0);
  EXPECT_GE(standing.above, standing.far_above);
  EXPECT_EQ(standing.negative, 0u) << "no coupling counts by this goal";
  const Goal easy = Goal::of(Angle::degrees(179), Angle::degrees(0.1));
  const GoalStanding met = standing_of(fan, easy);
  EXPECT_EQ(met.above + met.below, 0u);
  EXPECT_EQ(met.largest, standing.largest) << "which no goal changes";
}

}  // namespace
}  // namespace cover
