#include "disks/packing/packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "disks/packing/connect_holes.hpp"
#include "disks/packing/corner_disks.hpp"
#include "disks/packing/reduce_cycles.hpp"
#include "disks/packing/search/first_contact.hpp"
#include "support/filling_checks.hpp"
#include "support/inputs/shapes.hpp"

namespace cover::disks {
namespace {

/// A region inside the unit square after stage A.
struct Started {
  Packing packing;
  std::vector<std::array<Index, 2>> pairs;

  explicit Started(const RegionBoundary& boundary) {
    const FillTask task = testing::task_of(boundary);
    const CdtResult cdt = triangulate_domain(boundary.points, boundary.sides);
    packing.draft.points = task.points;
    pairs = place_corner_disks(packing, cdt.triangulation, task.chords, 0.46);
  }
};

/// Every cycle is closed, of the size it says, and its sides touch.
void expect_sound(const Packing& p) {
  for (Index c = 0; c < p.cycles.size(); ++c) {
    Index s = p.cycles[c].side;
    for (Index k = 0; k < p.cycles[c].size; ++k, s = p.sides[s].next) {
      ASSERT_EQ(p.sides[s].cycle, c);
      ASSERT_EQ(p.sides[p.sides[s].next].prev, s);
      if (p.sides[s].is_full_circle()) continue;
      ASSERT_EQ(p.sides[s].end, p.sides[p.sides[s].next].start);
      const Point t = p.point(p.sides[s].end);
      EXPECT_NEAR(signed_distance(p.element_of(s), t), 0, 1e-12);
      EXPECT_NEAR(signed_distance(p.element_of(p.sides[s].next), t), 0, 1e-3);
    }
    ASSERT_EQ(s, p.cycles[c].side);
  }
}

/// No two disks overlap by more than snapping allows, and none crosses a line.
void expect_packed(const Packing& p, double tolerance) {
  for (std::size_t i = 0; i < p.elements.size(); ++i) {
    if (p.elements[i].is_line()) continue;
    for (std::size_t j = 0; j < p.elements.size(); ++j) {
      if (i == j) continue;
      const double gap = obstacle_distance(p.elements[j], p.elements[i].c) - p.elements[i].r;
      EXPECT_GE(gap, -tolerance * p.elements[i].r) << i << " " << j;
    }
  }
}

RegionBoundary star_with_holes() {
  std::mt19937_64 random(3);
  return testing::boundary_of({testing::random_star(30, 0.6, random, {0.5, 0.5}, 0.5),
                               testing::reversed(testing::regular_polygon(5, 0.1, {0.4, 0.5})),
                               testing::reversed(testing::regular_polygon(3, 0.05, {0.6, 0.5}))},
                              {{0.55, 0.62}});
}

TEST(Packing, CornerDisksMakeOneCyclePerLoopAndPoint) {
  const Started s(star_with_holes());
  EXPECT_EQ(s.packing.cycles.size(), 4U);
  EXPECT_FALSE(s.pairs.empty());
  expect_sound(s.packing);
  expect_packed(s.packing, 1e-9);
  for (const Side& side : s.packing.sides) {
    if (s.packing.elements[side.element].is_line()) {
      EXPECT_TRUE(s.packing.elements[s.packing.sides[side.next].element].is_disk());
    }
  }
}

TEST(Packing, HolesAreJoinedAndCyclesReduced) {
  Started s(star_with_holes());
  ASSERT_TRUE(connect_holes(s.packing, s.pairs, 1e-6));
  std::size_t sides = 0;
  for (const Cycle& c : s.packing.cycles) sides += c.size;
  const std::size_t cycles = s.packing.cycles.size(), disks = s.packing.elements.size();
  expect_sound(s.packing);
  ASSERT_TRUE(reduce_cycles(s.packing, 1e-6));
  expect_sound(s.packing);
  expect_packed(s.packing, 1e-6);
  for (const Cycle& c : s.packing.cycles) EXPECT_TRUE(c.size == 3 || c.size == 4);
  // At most m - 4 disks for a cycle of m sides.
  EXPECT_LE(s.packing.elements.size() - disks, sides - 4 * cycles);
}

TEST(FirstContact, IsEmptyAndTouchesThreeSides) {
  Started s(star_with_holes());
  ASSERT_TRUE(connect_holes(s.packing, s.pairs, 1e-6));
  const Packing& p = s.packing;
  std::size_t found = 0;
  for (Index i = 0; i < p.sides.size(); ++i) {
    const auto disk = first_contact(p, i, p.sides[i].next, p.point(p.sides[i].end));
    if (!disk) continue;
    ++found;
    for (const Contact& c : {disk->i, disk->j, disk->third}) {
      EXPECT_NEAR(signed_distance(p.element_of(c.side), disk->circle.c), disk->circle.r,
                  1e-9 * disk->circle.r);
      EXPECT_TRUE(p.is_on(c.side, c.at));
    }
    EXPECT_EQ(p.nearest_obstacle(disk->circle.c, disk->circle.r * (1 - 1e-8), kNone, kNone, kNone),
              kNone);
  }
  EXPECT_EQ(found, p.sides.size());
}

TEST(Index, FindsTheNearestObstacle) {
  const std::uint64_t seed = testing::test_seed(2);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Packing p;
  for (int k = 0; k < 200; ++k) {  // a bundle of slanting needles
    const Point a{0.05 + 0.0005 * k, 0.1};
    p.add_element(make_line(a, a + Vector{0.7, 0.2 + 0.6 * uniform(random)}, 0));
  }
  for (int k = 0; k < 800; ++k) {
    p.add_element(
        make_disk({uniform(random), uniform(random)}, std::exp(-4 - 10 * uniform(random)), 0));
  }
  p.build_index();
  for (int k = 0; k < 500; ++k) {
    const Point x{uniform(random), uniform(random)};
    const double bound = std::exp(-6 * uniform(random));
    double best = bound;
    std::vector<Index> within;
    for (Index e = 0; e < p.elements.size(); ++e) {
      const double distance = obstacle_distance(p.elements[e], x);
      best = std::min(best, distance);
      if (distance < bound) within.push_back(e);
    }
    const Index found = p.nearest_obstacle(x, bound, kNone, kNone, kNone);
    ASSERT_EQ(found == kNone, within.empty());
    if (found != kNone) {
      EXPECT_EQ(obstacle_distance(p.elements[found], x), best);
    }
    EXPECT_EQ(p.elements_within(x, bound, kNone), within);
  }
}

}  // namespace
}  // namespace cover::disks
