// What an excerpt has reached.
#include "quality/fault/tally.hpp"

#include <gtest/gtest.h>

#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(Standing, OfAFanCountsWhatMissesTheGoalGiven) {
  const MutableMesh fan = cdt_mesh(boundary_of({regular_polygon(20, 1, {0, 0})}));
  const Goal goal = default_goal();
  const Tally tally = tally_of(fan, goal);
  EXPECT_GT(tally.above, 0u);
  EXPECT_GT(tally.below, 0u) << "an ear has two angles of 9 degrees";
  EXPECT_GT(tally.large, 0);
  EXPECT_GE(tally.above, tally.far_above);
  EXPECT_EQ(tally.negative, 0u) << "no coupling counts by this goal";
  const Goal easy = Goal::of(Angle::degrees(179), Angle::degrees(0.1));
  const Tally met = tally_of(fan, easy);
  EXPECT_EQ(met.above + met.below, 0u);
  EXPECT_EQ(met.largest, tally.largest) << "which no goal changes";
}

}  // namespace
}  // namespace cover
