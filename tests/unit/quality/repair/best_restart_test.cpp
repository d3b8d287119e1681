#include "quality/repair/best_restart.hpp"

#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(BestRestart, IsNoWorseAndKeepsTheCeiling) {
  const RegionBoundary boundary = boundary_of(
      {{{0, 0}, {9.08, -4.23}, {34.98, 5.61}, {33.54, 16.78}, {24.91, 25.02}, {21.82, 25.77}}});
  const MutableMesh mesh = cdt_mesh(boundary);
  const Merit before = merit_of(mesh, default_goal());
  Budget budget{1'000'000, {}};
  const auto [best, merit] = best_restart(mesh, before, default_goal(), before.large, budget);
  expect_sound(best, boundary);
  EXPECT_TRUE(is_better_by_largest(merit, before));
  EXPECT_FALSE(is_better_by_largest(merit, merit_of(best, default_goal())));
  EXPECT_LT(budget.left, 1'000'000u);

  const double none = default_goal().large - 1;
  const Restarted same = best_restart(mesh, before, default_goal(), none, budget);
  EXPECT_EQ(same.mesh.points, mesh.points);
  EXPECT_EQ(same.merit.large, before.large);
}

}  // namespace
}  // namespace cover
