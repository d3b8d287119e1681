#include "quality/plan/optimise.hpp"

#include "../mesh_checks.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

using namespace testing;

Budget large_budget() { return {100'000'000, {}, false}; }

TEST(Optimise, MeetsTheGoalOnASmoothStar) {
  const RegionBoundary boundary = flower(500);
  MutableMesh mesh = cdt_mesh(boundary);
  Budget budget = large_budget();
  const Merit merit = optimise(mesh, default_goal(), budget).merit;
  expect_sound(mesh, boundary);
  EXPECT_EQ(merit.above, 0u);
  EXPECT_DOUBLE_EQ(merit.large, default_goal().large);
  EXPECT_LT(merit.triangles, 3 * 500u);
  EXPECT_LT(budget.left, 100'000'000u);
}

TEST(Optimise, MeetsRightAnglesOnASmoothStar) {
  const RegionBoundary boundary = boundary_of({smooth_star(2000, 1)});
  const Goal goal = Goal::of(Angle::degrees(90), Angle::degrees(20));
  MutableMesh mesh = cdt_mesh(boundary);
  Budget budget{1'500'000, {}, false};  // three times what it takes
  const Merit merit = optimise(mesh, goal, budget).merit;
  expect_sound(mesh, boundary);
  EXPECT_EQ(merit.missed, 0u);
  EXPECT_LT(merit.triangles, 6 * 2000u);
}

TEST(Optimise, StopsWhenTheBudgetIsUsedUp) {
  const RegionBoundary boundary = flower(500);
  MutableMesh mesh = cdt_mesh(boundary);
  Budget budget{1000, {}, false};
  optimise(mesh, default_goal(), budget);
  EXPECT_TRUE(budget.is_used_up());
  expect_sound(mesh, boundary);
}

TEST(Optimise, ImprovingTheLargestNeverMakesItWorse) {
  const std::uint64_t seed = test_seed(17);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  for (int k = 0; k < 20; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(5 + 2 * k, 0.3, random)});
    MutableMesh mesh = cdt_mesh(boundary);
    const Merit before = merit_of(mesh, default_goal());
    Budget budget = large_budget();
    const Merit after = improve_largest(mesh, default_goal(), budget);
    expect_sound(mesh, boundary);
    EXPECT_LE(after.large, before.large + 1e-9);
  }
}

}  // namespace
}  // namespace cover
