#include "quality/plan/optimise.hpp"

#include "../mesh_checks.hpp"
#include "quality/repair/kicks.hpp"
#include "quality/starts/one_star.hpp"

namespace cover {
namespace {

using namespace testing;

Budget large_budget() { return {100'000'000, {}, false}; }

TEST(Optimise, MeetsTheGoalOnASmoothStar) {
  const RegionBoundary boundary = smooth_star(500);
  MutableMesh mesh = cdt_mesh(boundary);
  Budget budget = large_budget();
  const Merit merit = optimise(mesh, default_goal(), budget);
  expect_sound(mesh, boundary);
  EXPECT_EQ(merit.above, 0u);
  EXPECT_DOUBLE_EQ(merit.large, default_goal().large);
  EXPECT_LT(merit.triangles, 3 * 500u);
  EXPECT_LT(budget.left, 100'000'000u);
}

TEST(Optimise, StopsWhenTheBudgetIsUsedUp) {
  const RegionBoundary boundary = smooth_star(500);
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

TEST(Kicks, NeverMakeItWorse) {
  const std::uint64_t seed = test_seed(23);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  int better = 0;
  for (int k = 0; k < 20; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(7, 0.5, random)});
    MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(95), Angle::degrees(0)));
    Merit merit = merit_of(mesh, mesh.goal());
    const Merit before = merit;
    Budget budget = large_budget();
    improve_by_kicks(mesh, mesh.goal(), merit, budget);
    expect_sound(mesh, boundary);
    EXPECT_FALSE(is_better(before, merit));
    better += is_better(merit, before) ? 1 : 0;
  }
  EXPECT_GT(better, 5);
}

TEST(Hub, JoinsEverySideToOneVertex) {
  const RegionBoundary boundary = boundary_of({regular_polygon(100, 2, {5, 5})});
  const MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(90), Angle::degrees(0)));
  std::uint64_t evaluations = 0;
  const auto star = hub_triangulation(mesh, boundary, evaluations);
  ASSERT_TRUE(star.has_value());
  EXPECT_EQ(star->triangles.size(), 100u);
  const auto at = locate_sides(*star, boundary.sides);
  MutableMesh hub(*star, 100, at, mesh.sides);
  hub.set_goal(mesh.goal());
  expect_sound(hub, boundary);
  EXPECT_TRUE(merit_of(hub, mesh.goal()).complete);
}

TEST(Hub, IsNoneWithAHoleOrABay) {
  std::uint64_t evaluations = 0;
  const RegionBoundary ring =
      boundary_of({regular_polygon(12, 2), reversed(regular_polygon(8, 1))});
  EXPECT_FALSE(hub_triangulation(cdt_mesh(ring), ring, evaluations).has_value());
  const RegionBoundary bay =
      boundary_of({{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}});
  EXPECT_FALSE(hub_triangulation(cdt_mesh(bay), bay, evaluations).has_value());
}

}  // namespace
}  // namespace cover
