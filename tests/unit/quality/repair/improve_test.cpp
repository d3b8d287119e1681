#include "quality/repair/improve.hpp"

#include <random>

#include "../coupled_meshes.hpp"
#include "../mesh_checks.hpp"
#include "../refine_limits.hpp"
#include "quality/mutable/cavity.hpp"
#include "quality/starts/delaunay_refinement.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(Improve, ReachesTheGoalOnASmoothStar) {
  const RegionBoundary boundary = flower(300);
  MutableMesh mesh = cdt_mesh(boundary);
  refine(mesh, limits_of(20));
  const double before = worst_excess(mesh);
  const ImproveResult result = improve(mesh, 1U << 30);
  expect_sound(mesh, boundary);
  EXPECT_FALSE(result.budget_used_up);
  EXPECT_LT(worst_excess(mesh), std::min(before, 0.1));
}

TEST(Improve, IsMonotone) {
  const std::uint64_t seed = test_seed(5);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  for (int k = 0; k < 20; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(8 + 3 * k, 0.2, random)});
    MutableMesh mesh = cdt_mesh(boundary);
    double before = worst_excess(mesh);
    for (const std::uint64_t budget : {10U, 100U, 100000U}) {
      improve(mesh, budget);
      expect_sound(mesh, boundary);
      EXPECT_LE(worst_excess(mesh), before);
      before = worst_excess(mesh);
    }
  }
}

TEST(Improve, EndsWhereAnExcessIsNoMoreThanRounding) {
  const std::uint64_t seed = test_seed(6);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> within(-0.2, 0.2);
  int rounded_up = 0;
  for (int k = 0; k < 500; ++k) {
    Loop loop;
    for (int i = 0; i < 6; ++i) {
      const double turn = 3.14159265358979 / 3 * i;
      loop.push_back({std::cos(turn) + within(random), std::sin(turn) + within(random)});
    }
    MutableMesh mesh = cdt_mesh(boundary_of({loop}));
    Cavity cavity(mesh);
    cavity.start(0);
    for (int i = 0; i < cavity.size();) i = cavity.grow(i) ? 0 : i + 1;
    Installed installed;
    if (!install_star(mesh, cavity, {within(random), within(random)}, installed)) continue;
    // The goal is the largest angle there is, so that its excess is zero but for rounding.
    Goal goal;
    goal.large = -1;
    for (int i = 0; i < installed.count; ++i) {
      const std::uint32_t t = installed.triangles[static_cast<std::size_t>(i)];
      const Corners at(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
      for (const double dot : at.dot) goal.large = std::max(goal.large, -dot / at.cross);
    }
    mesh.set_goal(goal);
    ASSERT_LT(worst_excess(mesh), 1e-15);
    rounded_up += worst_excess(mesh) > 0 ? 1 : 0;
    EXPECT_FALSE(improve(mesh, 100'000).budget_used_up) << k;
  }
  EXPECT_GT(rounded_up, 20);
}

TEST(Improve, KeepsAllEdgesDelaunayWhereThatIsStrict) {
  std::mt19937_64 random(6);
  for (int k = 0; k < 10; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(50, 0.5, random)});
    MutableMesh mesh = refined_minding_mesh(boundary, strict_goal(), 300);
    mesh.measure_all();
    EXPECT_GT(improve(mesh, 100'000).evaluations, 0u);
    EXPECT_EQ(negative_inside(mesh, boundary), 0u);
    expect_sound(mesh, boundary);
  }
}

}  // namespace
}  // namespace cover
