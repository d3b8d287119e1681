#include "quality/repair/search.hpp"

#include "../mesh_checks.hpp"
#include "quality/fault/merit.hpp"
#include "quality/moves/joint.hpp"
#include "quality/repair/improve.hpp"
#include "quality/starts/delaunay_refinement.hpp"

namespace cover {
namespace {

using namespace testing;

/// Improved as far as single vertices go, for a goal that is hard to meet.
MutableMesh stuck_mesh(const RegionBoundary& boundary) {
  MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(93), Angle::degrees(25)));
  RefineLimits limits;
  limits.smallest_cot = 2.2;
  limits.budget = 1000;
  refine(mesh, limits);
  improve(mesh, 1U << 30);
  return mesh;
}

std::size_t left_in(const MutableMesh& mesh) {
  return static_cast<std::size_t>(
      std::count_if(mesh.excess.begin(), mesh.excess.end(), [](double e) { return e > 1e-9; }));
}

TEST(Search, FindsWhatImprovementDoesNot) {
  const RegionBoundary boundary = flower(300);
  MutableMesh mesh = stuck_mesh(boundary);
  const Goal goal = mesh.goal();
  const Merit before = merit_of(mesh, goal);
  const std::size_t left = left_in(mesh);
  ASSERT_GT(left, 0u);
  Budget budget{100'000'000, {}, false};
  search_excerpts(mesh, goal, budget);
  expect_sound(mesh, boundary);
  EXPECT_FALSE(is_better_by_largest(before, merit_of(mesh, goal)));
  EXPECT_LT(3 * left_in(mesh), left);
}

TEST(Search, NeverMakesItWorseAndSaysWhenTheBudgetEnds) {
  const std::uint64_t seed = test_seed(29);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  bool was_too_small = false;
  for (int k = 0; k < 12; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(6 + 2 * k, 0.4, random)});
    MutableMesh mesh = cdt_mesh(boundary);
    const Merit before = merit_of(mesh, default_goal());
    Budget budget{300, {}, false};
    search_excerpts(mesh, default_goal(), budget);
    expect_sound(mesh, boundary);
    EXPECT_FALSE(is_better_by_largest(before, merit_of(mesh, default_goal())));
    was_too_small = was_too_small || budget.was_too_small;
  }
  EXPECT_TRUE(was_too_small);
}

TEST(Search, ABudgetIsTooSmallOnlyWhereSomethingIsLeft) {
  std::mt19937_64 random(31);
  std::size_t all_mended = 0;
  for (int k = 0; k < 12; ++k) {
    const MutableMesh start = cdt_mesh(boundary_of({random_star(20 + 2 * k, 0.4, random)}));
    for (const bool in_parts : {false, true}) {
      for (std::uint64_t budget = 1; budget < 200'000; budget += 1 + budget / 8) {
        MutableMesh mesh = start;
        Budget own{budget, {}, false};
        Sharing sharing;
        if (in_parts) sharing.part_size = 1;
        search_excerpts(mesh, default_goal(), own, Restarts::none, sharing);
        if (left_in(mesh) > 0) continue;
        ++all_mended;
        EXPECT_FALSE(own.was_too_small) << k << in_parts << ' ' << budget;
      }
    }
  }
  EXPECT_GT(all_mended, 0u);
}

TEST(Search, RestartsInsideOfExcerptsLeaveASoundMesh) {
  const RegionBoundary boundary = flower(300);
  MutableMesh mesh = stuck_mesh(boundary);
  const Goal goal = Goal::of(Angle::degrees(85), Angle::degrees(0));
  const double before = merit_of(mesh, goal).large;
  Budget budget{3'000'000, {}};
  search_excerpts(mesh, goal, budget, Restarts::at_last);
  expect_sound(mesh, boundary);
  EXPECT_LE(merit_of(mesh, goal).large, before);
}

TEST(JointPlacement, MovesWhereSingleVerticesAreStuck) {
  const RegionBoundary boundary = flower(300);
  MutableMesh mesh = stuck_mesh(boundary);
  std::size_t moved = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!(mesh.excess[t] > 1e-9)) continue;
    const double before = worst_excess(mesh);
    const UnsetVector<double> excess = mesh.excess;
    const JointMove move = place_jointly(mesh, t);
    if (!move.has_moved) {
      EXPECT_EQ(mesh.excess, excess);
      continue;
    }
    ++moved;
    EXPECT_GT(move.evaluations, 0u);
    EXPECT_LE(worst_excess(mesh), before);
  }
  EXPECT_GT(moved, 0u);
  expect_sound(mesh, boundary);
}

}  // namespace
}  // namespace cover
