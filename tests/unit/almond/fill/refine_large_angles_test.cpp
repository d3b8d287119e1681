#include "almond/fill/refine_large_angles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "almond/fill/fill_refine.hpp"
#include "cdt/search/sight.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

FillTask task_of(const RegionBoundary& boundary, bool locked = false) {
  FillTask task;
  task.points = boundary.points;
  for (const auto& [a, b] : boundary.sides) task.chords.push_back({a, b, locked});
  return task;
}

std::vector<Point> points_of(const FillTask& task, const Filling& filling) {
  std::vector<Point> points = task.points;
  points.insert(points.end(), filling.added.begin(), filling.added.end());
  return points;
}

double smallest_nu(const std::vector<Point>& p, const Filling& filling) {
  double least = 4;
  for (const auto& [a, b, c] : filling.triangles) {
    least = std::min(
        {least, nu_at(p[b], p[a], p[c]), nu_at(p[c], p[b], p[a]), nu_at(p[a], p[c], p[b])});
  }
  return least;
}

double area(const std::vector<Point>& p, const Filling& filling) {
  double sum = 0;
  for (const auto& [a, b, c] : filling.triangles) sum += cross(p[b] - p[a], p[c] - p[a]) / 2;
  return sum;
}

TEST(RefineFiller, ReachesItsTargetAndNamesItsSplitsInOrder) {
  std::mt19937_64 random(testing::test_seed(3));
  for (int k = 0; k < 20; ++k) {
    const FillTask task = task_of(testing::boundary_of({testing::random_star(30, 0.05, random)}));
    const Filling filling = make_refine_filler()->fill(task, {});
    const auto points = points_of(task, filling);
    EXPECT_TRUE(filling.target_reached);
    EXPECT_GE(smallest_nu(points, filling), kRefineTarget * (1 - 1e-12));
    for (const auto& [a, b, c] : filling.triangles) {
      EXPECT_EQ(orientation(points[a], points[b], points[c]), Sign::positive);
    }
    for (const ChordSplit& split : filling.splits) {
      Point previous = points[task.chords[split.chord].a];
      const Point end = points[task.chords[split.chord].b];
      for (const std::uint32_t v : split.vertices) {
        EXPECT_GT(dot(points[v] - previous, end - previous), 0);
        EXPECT_NEAR(cross(points[v] - previous, end - previous), 0, 1e-15);
        previous = points[v];
      }
    }
  }
}

TEST(RefineFiller, KeepsLockedChordsWhole) {
  const FillTask task = task_of(testing::boundary_of({testing::regular_polygon(200)}), true);
  const Filling filling = make_refine_filler()->fill(task, {});
  EXPECT_TRUE(filling.splits.empty());
  EXPECT_TRUE(filling.target_reached);
  const auto points = points_of(task, filling);
  EXPECT_GE(smallest_nu(points, filling), kRefineTarget);
  EXPECT_NEAR(area(points, filling), 200 / 2.0 * std::sin(2 * 3.14159265358979323846 / 200), 1e-12);
}

TEST(RefineFiller, SaysWhenALockedChordIsInTheWay) {
  const auto boundary = testing::boundary_of({{{-1, 0}, {1, 0}, {0, 0.01}}});
  Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const FillTask task = task_of(boundary, true);
  ChordEdges edges;
  ASSERT_TRUE(match_chords(cdt, task.chords, edges).empty());
  const Refinement r = refine_large_angles(cdt, edges, task.chords, {kRefineTarget, 0.1, 100}, {});
  EXPECT_FALSE(r.target_reached);
  EXPECT_EQ(r.blocking.size(), 3U);
  EXPECT_EQ(cdt.triangles.size(), 1U);
}

TEST(RefineFiller, AsksForNoMoreThanItsChordsDo) {
  FillTask task = task_of(testing::boundary_of({{{-1, 0}, {1, 0}, {0, 0.01}}}));
  for (Chord& chord : task.chords) chord.nu = 0.001;
  EXPECT_EQ(make_refine_filler()->fill(task, {}).triangles.size(), 1U);
}

TEST(MatchChords, FindsWhatIsNoBoundary) {
  const auto boundary = testing::boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  std::vector<Chord> chords = task_of(boundary).chords;
  ChordEdges edges;
  EXPECT_TRUE(match_chords(cdt, chords, edges).empty());
  std::swap(chords[1].a, chords[1].b);
  EXPECT_FALSE(match_chords(cdt, chords, edges).empty());
}

/// A ring of chords with a gap is no boundary, though each of them is in its place.
TEST(MatchChords, BlamesWhatIsBesideAGap) {
  const auto boundary = testing::boundary_of({{{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}}});
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  std::vector<Chord> chords = task_of(boundary).chords;
  const Chord lost = chords[1];
  chords.erase(chords.begin() + 1);
  std::vector<std::uint32_t> beside;
  for (std::uint32_t c = 0; c < chords.size(); ++c) {
    if (chords[c].b == lost.a || chords[c].a == lost.b) beside.push_back(c);
  }
  ASSERT_EQ(beside.size(), 2U);
  ChordEdges edges;
  EXPECT_EQ(match_chords(cdt, chords, edges), beside);
}

TEST(WalkStraight, StopsAtLockedEdgesAndTheOutside) {
  const auto boundary =
      testing::boundary_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 1}, {2, 3}}}, {{1, 2}, {3, 2}});
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const auto triangle_with = [&](Point p) {
    for (std::uint32_t t = 0; t < cdt.triangles.size(); ++t) {
      for (const std::uint32_t v : cdt.triangles[t].v) {
        if (cdt.points[v] == p) return t;
      }
    }
    return kNone;
  };
  const std::uint32_t start = triangle_with({1, 2});
  const Triangle& f = cdt.triangles[start];
  const Point inside =
      midpoint(cdt.points[f.v[0]], midpoint(cdt.points[f.v[1]], cdt.points[f.v[2]]));
  EXPECT_FALSE(walk_straight(cdt, start, inside, {3, 2.01}).arrived);
  EXPECT_FALSE(walk_straight(cdt, start, inside, {-1, 2}).arrived);
  EXPECT_TRUE(walk_straight(cdt, start, inside, {1, 3.5}).arrived);
}

}  // namespace
}  // namespace cover
