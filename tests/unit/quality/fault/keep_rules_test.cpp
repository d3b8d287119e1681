// The rules by which a change is kept: one case for each of their lines.
#include "quality/fault/keep_rules.hpp"

#include <gtest/gtest.h>

namespace cover {
namespace {

constexpr double kHalfAPercent = 0.995, kTwoPercent = 0.98;  ///< what is left of an excess

/// Three large angles, one of them above 120 degrees, four small ones, two negative couplings.
Tally middling() { return {0.8, 0.6, 3, 1, 0.5, 4, 2}; }

/// middling(), changed.
template <class Change>
Tally middling_but(Change change) {
  Tally tally = middling();
  change(tally);
  return tally;
}

TEST(Gain, NothingIsNone) { EXPECT_FALSE(is_gain(middling(), middling())); }

TEST(Gain, FewerNegativeCouplingsWinWhateverSmallAnglesPay) {
  const Tally fewer = middling_but([](Tally& s) {
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
  EXPECT_FALSE(is_gain(middling_but([](Tally& s) {
                         s.negative = 0;
                         s.large = 0.61;
                       }),
                       middling()));
}

TEST(Gain, NothingOfLargeAnglesMayBeWorse) {
  // Each is worse alone, while all the others are better.
  const auto all_better = [](Tally& s) { s = {0.7, 0.3, 1, 0, 0.1, 1, 2}; };
  const auto with = [&](auto change) {
    return middling_but([&](Tally& s) {
      all_better(s);
      change(s);
    });
  };
  ASSERT_TRUE(is_gain(with([](Tally&) {}), middling()));
  EXPECT_FALSE(is_gain(with([](Tally& s) { s.largest = 0.81; }), middling()));
  EXPECT_FALSE(is_gain(with([](Tally& s) { s.large = 0.61; }), middling()));
  EXPECT_FALSE(is_gain(with([](Tally& s) { s.above = 4; }), middling()))
      << "a smaller excess does not pay for one triangle more";
  EXPECT_FALSE(is_gain(with([](Tally& s) { s.far_above = 2; }), middling()));
}

TEST(Gain, OneLargeAngleFewerWinsWhateverSmallOnesPay) {
  const auto paid = [](Tally& s) {
    s.small = 5;
    s.below = 40;
  };
  EXPECT_TRUE(is_gain(middling_but([&](Tally& s) {
                        paid(s);
                        s.above = 2;
                      }),
                      middling()));
  EXPECT_TRUE(is_gain(middling_but([&](Tally& s) {
                        paid(s);
                        s.far_above = 0;
                      }),
                      middling()));
  EXPECT_TRUE(is_gain(middling_but([&](Tally& s) {
                        paid(s);
                        s.large *= kTwoPercent;
                      }),
                      middling()));
}

TEST(Gain, HalfAPercentOfAnExcessIsNoneTwoAre) {
  const auto large = [](double part) { return middling_but([&](Tally& s) { s.large *= part; }); };
  EXPECT_FALSE(is_gain(large(kHalfAPercent), middling()));
  EXPECT_TRUE(is_gain(large(kTwoPercent), middling()));
  const auto small = [](double part) { return middling_but([&](Tally& s) { s.small *= part; }); };
  EXPECT_FALSE(is_gain(small(kHalfAPercent), middling()));
  EXPECT_TRUE(is_gain(small(kTwoPercent), middling()));
}

TEST(Gain, ASmallerLargestAngleAloneIsNone) {
  EXPECT_FALSE(is_gain(middling_but([](Tally& s) { s.largest = 0.4; }), middling()));
}

TEST(Gain, LargeAnglesNeverPayForSmallOnes) {
  // Hardly larger: it is worse by far less than the one in a hundred that would count as better.
  EXPECT_FALSE(is_gain(middling_but([](Tally& s) {
                         s.large *= 1.0001;
                         s.small = 0;
                         s.below = 0;
                       }),
                       middling()));
}

TEST(Gain, OfSmallAnglesNeitherExcessNorCountPaysForTheOther) {
  EXPECT_TRUE(is_gain(middling_but([](Tally& s) { s.below = 3; }), middling()));
  EXPECT_FALSE(is_gain(middling_but([](Tally& s) {
                         s.below = 3;
                         s.small = 0.51;
                       }),
                       middling()));
  EXPECT_FALSE(is_gain(middling_but([](Tally& s) {
                         s.below = 5;
                         s.small = 0.1;
                       }),
                       middling()));
}

/// Five triangles above the goal, two of them above 120 degrees.
Merit five_above() {
  Merit merit;
  merit.large = 1.0;
  merit.above = 5;
  merit.far_above = 2;
  merit.small = 3;
  merit.triangles = 60;
  merit.fault = {0.3, 0.4};
  return merit;
}

/// five_above(), changed.
template <class Change>
Merit five_above_but(Change change) {
  Merit merit = five_above();
  change(merit);
  return merit;
}

TEST(ImprovementOf, IsOneInAHundredLess) {
  EXPECT_DOUBLE_EQ(improvement_of(2), 1.98);
  EXPECT_DOUBLE_EQ(improvement_of(0), 0);
}

TEST(KickRule, KeepsWhatIsBetterByTheLargestAngleWithNoMoreTrianglesAboveTheGoal) {
  EXPECT_FALSE(is_kick_kept(five_above(), five_above())) << "nothing is better";
  EXPECT_TRUE(is_kick_kept(five_above_but([](Merit& m) { m.large = 0.5; }), five_above()));
  EXPECT_TRUE(is_kick_kept(five_above_but([](Merit& m) { m.above = 4; }), five_above()));
  EXPECT_TRUE(is_kick_kept(five_above_but([](Merit& m) { m.small = 2.9; }), five_above()));
  // However much smaller the largest angle is.
  EXPECT_FALSE(is_kick_kept(five_above_but([](Merit& m) {
                              m.large = 0.1;
                              m.above = 6;
                            }),
                            five_above()));
}

TEST(CutRule, FewerTrianglesAboveAreWorthACutIfNoAngleIsLarger) {
  const Goal goal = Goal::of(Angle::degrees(100), Angle::degrees(20));
  EXPECT_TRUE(is_cut_kept(five_above_but([](Merit& m) { m.above = 4; }), five_above(), goal));
  EXPECT_FALSE(is_cut_kept(five_above_but([](Merit& m) {
                             m.above = 1;
                             m.large = 1.001;
                           }),
                           five_above(), goal));
}

TEST(CutRule, AsManyAreIfTheLargestLosesAFifthOfItsExcess) {
  const Goal goal = Goal::of(Angle::degrees(100), Angle::degrees(20));
  const auto with_excess = [&](double part) {
    return five_above_but([&](Merit& m) { m.large = goal.large + part * (1.0 - goal.large); });
  };
  EXPECT_FALSE(is_cut_kept(with_excess(0.85), five_above(), goal));
  EXPECT_TRUE(is_cut_kept(with_excess(0.75), five_above(), goal));
  EXPECT_FALSE(is_cut_kept(five_above_but([](Merit& m) {
                             m.large = 0.2;
                             m.above = 6;
                           }),
                           five_above(), goal))
      << "one triangle more";
}

TEST(CouplingRule, NoFaultMayGrow) {
  EXPECT_TRUE(is_kept_beside_couplings(five_above(), five_above()));
  EXPECT_TRUE(
      is_kept_beside_couplings(five_above_but([](Merit& m) { m.fault.wide = 0.4; }), five_above()))
      << "only the worst counts";
  EXPECT_FALSE(is_kept_beside_couplings(five_above_but([](Merit& m) {
                                          m.negative = 0;
                                          m.fault.wide = 0.41;
                                        }),
                                        five_above()));
}

}  // namespace
}  // namespace cover
