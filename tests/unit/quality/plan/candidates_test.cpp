// Each way to make a candidate by itself, and what it promises of it.
#include "quality/plan/candidates.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "../mesh_checks.hpp"
#include "unit/quality/plan/planned_region.hpp"

namespace cover {
namespace {

using namespace testing;

Options angles_alone() {
  Options options;
  options.couplings = Couplings::last;
  return options;
}

struct Made : PlannedRegion {
  explicit Made(RegionBoundary region, Options asked = angles_alone())
      : PlannedRegion(std::move(region), std::move(asked)) {}
};

/// No triangle is turned over, and all of the region is covered.
void expect_covering(const Made& made, const Candidate& candidate) {
  double area = 0;
  const MutableMesh& mesh = *candidate.mesh;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    const Point a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    EXPECT_EQ(orientation(a, b, c), Sign::positive);
    area += cross(b - a, c - a) / 2;
  }
  EXPECT_NEAR(area, area_of(made.boundary), 1e-9 * area);
}

RegionBoundary twenty_sides() { return boundary_of({regular_polygon(20)}); }

TEST(Candidates, AsItIsHasNoNewVertexAndItsMeritIsByTheGoalAsked) {
  const Made made(twenty_sides());
  EXPECT_EQ(made.cdt.mesh->points.size(), 20U);
  EXPECT_EQ(made.cdt.merit.triangles, 18U);
  EXPECT_EQ(made.cdt.method, "cdt");
  EXPECT_FALSE(made.cdt.merit.complete);
  EXPECT_TRUE(made.make.goal().has_same_angles(default_goal()));
  expect_covering(made, made.cdt);
}

TEST(Candidates, CouplingsCountInTheGoalUnlessTheyComeLast) {
  const Made first(twenty_sides(), Options{}), last(twenty_sides());
  EXPECT_GT(first.make.goal().coupling.weight, 0);
  EXPECT_TRUE(first.make.goal().coupling.inside);
  EXPECT_EQ(last.make.goal().coupling.weight, 0);
}

TEST(Candidates, OneStarHasRoomIfItsAnglesAddUpTo360Degrees) {
  EXPECT_TRUE(Made(boundary_of({regular_polygon(17)})).make.has_room_for_one_star());
  EXPECT_FALSE(Made(boundary_of({regular_polygon(18)})).make.has_room_for_one_star());
  Made twelve(boundary_of({regular_polygon(12)}));
  const std::optional<Candidate> star = twelve.make.one_star(twelve.cdt);
  ASSERT_TRUE(star);
  EXPECT_EQ(star->merit.triangles, 12U);
  EXPECT_TRUE(star->merit.complete) << "75, 75 and 30 degrees";
  expect_covering(twelve, *star);
}

TEST(Candidates, ARegionThatNoVertexSeesWholeHasNoStar) {
  // A comb of two teeth.
  Made comb(boundary_of({{{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}}));
  EXPECT_FALSE(comb.make.one_star(comb.cdt));
}

TEST(Candidates, RefinedAndImprovedMeetsTheTargetsOfASmoothStar) {
  Made made(flower(300));
  const Candidate refined = made.make.optimised(made.cdt, SearchAfter::few);
  EXPECT_TRUE(refined.merit.complete);
  EXPECT_EQ(refined.method, "refined, improved");
  expect_covering(made, refined);
}

TEST(Candidates, MoreEffortForOneStepSpendsMoreOfTheBudget) {
  std::mt19937_64 random(5);
  const RegionBoundary spiky = boundary_of({random_star(60, 0.3, random)});
  Made little(spiky), all(spiky);
  const Candidate few = little.make.optimised(little.cdt, SearchAfter::nothing);
  const Candidate many = all.make.optimised(all.cdt, SearchAfter::all);
  expect_covering(little, few);
  expect_covering(all, many);
  EXPECT_FALSE(all.make.ranking().order().is_better(few.merit, many.merit));
}

TEST(Candidates, ImprovedIsNoWorse) {
  std::mt19937_64 random(7);
  for (int k = 0; k < 8; ++k) {
    Made made(boundary_of({random_star(10 + 3 * k, 0.3, random)}));
    const Candidate better = made.make.improved(made.cdt);
    EXPECT_FALSE(made.make.ranking().order().is_better(made.cdt.merit, better.merit)) << k;
    expect_covering(made, better);
  }
}

TEST(Candidates, NarrowedHasFewerAnglesAbove120DegreesWhateverSmallOnesPay) {
  std::mt19937_64 random(11);
  std::size_t before = 0, after = 0;
  for (int k = 0; k < 8; ++k) {
    Made made(boundary_of({random_star(24, 0.2, random)}));
    const Candidate narrowed = made.make.narrowed(made.cdt, made.cdt, kFarAbove, 1000);
    EXPECT_FALSE(made.make.ranking().order().is_better(made.cdt.merit, narrowed.merit)) << k;
    expect_covering(made, narrowed);
    before += made.cdt.merit.far_above;
    after += narrowed.merit.far_above;
  }
  EXPECT_LT(after, before);
}

TEST(Candidates, AlmondsAreWithinTheBound) {
  std::mt19937_64 random(13);
  for (int k = 0; k < 4; ++k) {
    Made made(boundary_of({random_star(20, 0.1, random)}));
    const Candidate almonds = made.make.from_almonds();
    ASSERT_FALSE(almonds.mesh->triangles.empty());
    EXPECT_EQ(almonds.method, "almond");
    EXPECT_TRUE(made.make.ranking().is_within_bound(almonds));
    expect_covering(made, almonds);
    EXPECT_TRUE(made.make.take_almonds()) << "asked once, handed over";
  }
}

TEST(Candidates, CoupledHasNoNegativeCouplingInside) {
  std::mt19937_64 random(17);
  for (int k = 0; k < 4; ++k) {
    Made made(boundary_of({random_star(20, 0.3, random)}), Options{});
    const Candidate flipped = made.make.coupled(made.make.from_almonds());
    std::size_t inside = 0;
    const MutableMesh& mesh = *flipped.mesh;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.is_hole(t)) continue;
      const auto& [v, n] = mesh.triangles[t];
      for (const Corner i : kCorners) {
        if (is_side(n[i]) || n[i] < t) continue;
        const Corners corners(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
        inside += corners.dot[i] / corners.cross + mesh.cot_opposite(n[i], v[i.previous()]) < -1e-9;
      }
    }
    EXPECT_EQ(inside, 0U);
  }
}

TEST(Candidates, TheOwnGoalIsWhatTheWorstSideForces) {
  // The notch sees the lower side flat.
  const Made made(boundary_of({{{0, 0}, {8, 0}, {8, 1}, {4, 0.75}, {0, 1}}}));
  const Goal own = made.make.own_goal(*made.cdt.mesh);
  EXPECT_GT(own.large, made.make.goal().large);
  EXPECT_EQ(own.small, made.make.goal().small);
  const double flat = 2 * std::atan2(4, 0.75);
  EXPECT_NEAR(own.large, -1 / std::tan(flat), 1e-9);
}

TEST(Candidates, AnotherGoalIsForOneCallAndLeavesNoTrace) {
  Made made(twenty_sides());
  const Goal asked = made.make.goal();
  const Goal other = made.make.goal_for(Angle::degrees(90), Angle::degrees(30));
  Goal seen;
  const Candidate found = made.make.with_goal(other, [&] {
    seen = made.make.goal();
    return made.make.as_it_is();
  });
  EXPECT_EQ(seen, other);
  EXPECT_EQ(made.make.goal(), asked);
  EXPECT_EQ(found.merit.large, made.cdt.merit.large) << "measured by the goal asked";
  EXPECT_EQ(found.merit.above, made.cdt.merit.above);
}

TEST(Candidates, SixteenPointsAreTiny) {
  EXPECT_TRUE(Made(boundary_of({regular_polygon(16)})).make.is_tiny());
  EXPECT_FALSE(Made(boundary_of({regular_polygon(17)})).make.is_tiny());
}

TEST(Ranking, NoneAboveTheCeilingReplacesOneBelow) {
  const Made made(twenty_sides());
  Ranking ranking;
  ranking.set_order({.prefer = Prefer::balanced});
  Candidate low = made.cdt, high = made.cdt;
  low.merit.large = 1;
  low.merit.fault = {0.5, 0.5};
  high.merit.large = 2;
  high.merit.fault = {0.1, 0.1};
  Candidate best = low;
  ranking.take_if_better(best, high);
  EXPECT_EQ(best.merit.large, 2) << "no ceiling yet";
  ranking.lower_ceiling(1.5);
  best = low;
  ranking.take_if_better(best, high);
  EXPECT_EQ(best.merit.large, 1);
  best = high;
  ranking.take_if_better(best, low);
  EXPECT_EQ(best.merit.large, 1) << "the other way round it does";
}

}  // namespace
}  // namespace cover
