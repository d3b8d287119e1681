#include "quality/moves/kick.hpp"

#include <map>
#include <set>

#include "small_mesh.hpp"

namespace cover {
namespace {

using namespace testing;

constexpr Kick kMiddle{Kick::What::vertex_inside};
constexpr Kick on_edge(int i) { return {Kick::What::vertex_on_edge, i}; }
constexpr Kick flip_of(int i) { return {Kick::What::flip, i}; }
constexpr Kick removal_of(int i) { return {Kick::What::removal, i}; }

/// A square of two triangles:
///
///      3-----2
///      |   .'|       triangle 0 below, triangle 1 above
///      | .'  |
///      0-----1
SmallMesh square(double corner = 1, const std::vector<IndexPair>& slits = {}) {
  return {goal_of(100, 20),
          {{0, 0}, {1, 0}, {corner, corner}, {0, 1}},
          {},
          {{0, 1, 2}, {0, 2, 3}},
          slits};
}

void expect_refused(SmallMesh& small, Kick kick) {
  const Everything before(small.mesh);
  EXPECT_FALSE(do_kick(small.mesh, 0, kick)) << static_cast<int>(kick.what) << " at " << kick.at;
  EXPECT_TRUE(Everything(small.mesh) == before);
}

TEST(Kick, OneIsInTheMiddleAndEachOtherAtThreePlaces) {
  std::map<Kick::What, std::set<int>> places;
  for (const Kick kick : kKicks) EXPECT_TRUE(places[kick.what].insert(kick.at).second);
  EXPECT_EQ(places[Kick::What::vertex_inside].size(), 1U);
  for (const auto what : {Kick::What::vertex_on_edge, Kick::What::flip, Kick::What::removal})
    EXPECT_EQ(places[what], (std::set{0, 1, 2}));
}

TEST(Kick, PutsAVertexIntoTheMiddleForWorse) {
  SmallMesh small = square();
  const double before = worst_excess(small.mesh);
  ASSERT_TRUE(do_kick(small.mesh, 0, kMiddle));
  expect_sound(small.mesh, small.boundary);
  EXPECT_EQ(small.mesh.triangle_count(), 4U);
  ASSERT_EQ(small.mesh.points.size(), 5U);
  EXPECT_NEAR(small.mesh.points[4].x, 2.0 / 3, 1e-15);
  EXPECT_NEAR(small.mesh.points[4].y, 1.0 / 3, 1e-15);
  EXPECT_GT(worst_excess(small.mesh), before);
}

TEST(Kick, PutsAVertexOnAnInnerEdgeAndOnNoSide) {
  SmallMesh small = square();
  expect_refused(small, on_edge(0));
  expect_refused(small, on_edge(1));
  ASSERT_TRUE(do_kick(small.mesh, 0, on_edge(2)));  // from corner 2 to corner 0
  expect_sound(small.mesh, small.boundary);
  EXPECT_EQ(small.mesh.triangle_count(), 4U);
  EXPECT_EQ(small.mesh.points.back(), (Point{0.5, 0.5}));
}

TEST(Kick, FlipsAnInnerEdgeAndNoSide) {
  SmallMesh small = square();
  expect_refused(small, flip_of(0));
  expect_refused(small, flip_of(2));
  ASSERT_TRUE(do_kick(small.mesh, 0, flip_of(1)));
  expect_sound(small.mesh, small.boundary);
  for (const MeshTriangle& t : small.mesh.triangles) {
    EXPECT_EQ(std::count(t.v.begin(), t.v.end(), 1U) + std::count(t.v.begin(), t.v.end(), 3U), 2);
  }
}

TEST(Kick, RefusesWhatWouldTurnOver) {
  SmallMesh reflex = square(0.25);  // corner 2 lies below the line from 1 to 3
  expect_refused(reflex, flip_of(1));
  SmallMesh flat = square(0.5);  // on that line
  expect_refused(flat, flip_of(1));
}

TEST(Kick, RefusesSlits) {
  SmallMesh slit = square(1, {{0, 2}});
  expect_refused(slit, on_edge(2));
  expect_refused(slit, flip_of(1));
}

TEST(Kick, TakesAFreeVertexAwayAndNoFixedOne) {
  SmallMesh small = hexagon_star(goal_of(65, 55), {0, 0});  // corners 0, 1 and 6
  expect_refused(small, removal_of(0));
  expect_refused(small, removal_of(1));
  ASSERT_LE(worst_excess(small.mesh), 0);
  ASSERT_TRUE(do_kick(small.mesh, 0, removal_of(2)));
  expect_sound(small.mesh, small.boundary);
  EXPECT_EQ(small.mesh.triangle_count(), 4U);
  EXPECT_EQ(small.mesh.home[6], kNone);
  EXPECT_GT(worst_excess(small.mesh), 0);
}

}  // namespace
}  // namespace cover
