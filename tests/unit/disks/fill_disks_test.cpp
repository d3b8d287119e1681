#include "disks/fill_disks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <cover/option_ranges.hpp>

#include "support/filling_checks.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using testing::boundary_of;
using testing::FillingFacts;
using testing::Loop;
using testing::regular_polygon;
using testing::reversed;

/// Fills a region and checks the result, which may be of a later attempt.
FillingFacts expect_nonobtuse(const FillTask& task, DiskFillOptions options = {}) {
  PackingRecord record;
  options.record = &record;
  const Filling filling = make_disk_filler(options)->fill(task, {});
  const FillingFacts facts = testing::check_filling(task, filling);
  EXPECT_EQ(facts.fault, "");
  EXPECT_TRUE(filling.target_reached) << filling.remark;
  EXPECT_LE(facts.largest_angle, kLargestSnapped);
  return facts;
}

FillingFacts expect_nonobtuse(const RegionBoundary& boundary, const DiskFillOptions& options = {}) {
  return expect_nonobtuse(testing::task_of(boundary), options);
}

constexpr DiskFillOptions kAsPublished{.removes_spare_vertices = false};

Loop square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

TEST(FillDisks, ASquareTakes41VerticesAndAnLNoMoreThan140) {
  FillingFacts facts = expect_nonobtuse(boundary_of({square(0, 0, 1)}), kAsPublished);
  EXPECT_EQ(facts.triangles, 64U);
  EXPECT_EQ(facts.vertices, 41U);
  const auto l = boundary_of({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
  facts = expect_nonobtuse(l, kAsPublished);
  EXPECT_LE(facts.vertices, 140U);
  EXPECT_LT(expect_nonobtuse(l).vertices, facts.vertices);
}

TEST(FillDisks, RegularPolygonsTakeAtMost26TrianglesPerSide) {
  for (int n = 3; n <= 32; ++n) {
    SCOPED_TRACE(n);
    const FillingFacts facts = expect_nonobtuse(boundary_of({regular_polygon(n)}), kAsPublished);
    EXPECT_LE(facts.triangles, static_cast<std::size_t>(26 * n));
  }
}

TEST(FillDisks, HolesInAGridTakeAtMost85TrianglesPerVertex) {
  std::vector<Loop> loops{square(0, 0, 11)};
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) loops.push_back(reversed(square(1 + 2 * i, 1 + 2 * j, 1)));
  }
  const FillingFacts facts = expect_nonobtuse(boundary_of(loops), kAsPublished);
  EXPECT_LE(facts.triangles, 85U * 104U);
}

TEST(FillDisks, NothingIsObtuseBesideIsolatedPoints) {
  std::vector<Point> points;
  for (int i = 1; i < 6; ++i) {
    for (int j = 1; j < 6; ++j) points.push_back({i + 0.0, j + 0.0});
  }
  expect_nonobtuse(boundary_of({square(0, 0, 6)}, points));
  expect_nonobtuse(boundary_of({square(0, 0, 6)}, {{3, 3}}));
}

TEST(FillDisks, NothingIsObtuseInAnnuli) {
  expect_nonobtuse(boundary_of({regular_polygon(24), reversed(regular_polygon(24, 0.5))}));
  expect_nonobtuse(boundary_of({regular_polygon(24), reversed(regular_polygon(17, 0.5))}));
  expect_nonobtuse(boundary_of({regular_polygon(40), reversed(regular_polygon(40, 0.98))}));
  expect_nonobtuse(
      boundary_of({regular_polygon(24), reversed(regular_polygon(9, 0.3, {0.5, 0.1}))}));
}

TEST(FillDisks, NothingIsObtuseInAComb) {
  Loop comb{{0, 0}, {10, 0}};
  for (int k = 9; k >= 0; --k) {
    comb.push_back({k + 0.9, 3});
    comb.push_back({k + 0.45, 0.2});
    comb.push_back({k + 0.0, 3});
  }
  expect_nonobtuse(boundary_of({comb}));
}

TEST(FillDisks, NothingIsObtuseBesideCollinearAndNearlyCollinearVertices) {
  Loop loop;
  for (int k = 0; k < 10; ++k) loop.push_back({k + 0.0, 0});
  loop.push_back({10, 5});
  for (int k = 10; k > 0; --k) loop.push_back({k - 0.5, 5});
  expect_nonobtuse(boundary_of({loop}));
  for (std::size_t k = 1; k < loop.size(); k += 2) loop[k].y += k % 4 == 1 ? 1e-9 : -1e-9;
  expect_nonobtuse(boundary_of({loop}));
}

TEST(FillDisks, NothingIsObtuseInPinchedRegions) {
  // A hole that touches the outer boundary in a vertex, and two holes that touch each other.
  expect_nonobtuse(boundary_of(
      {{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, reversed({{2, 0}, {3, 1}, {2, 2}, {1, 1}})}));
  expect_nonobtuse(boundary_of(
      {square(0, 0, 6), reversed({{1, 1}, {3, 3}, {1, 4}}), reversed({{3, 3}, {5, 2}, {5, 4}})}));
  // Two squares that meet in a corner: the interior falls apart.
  FillTask task;
  task.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  task.chords = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}, {4, 5}, {5, 6}, {6, 2}};
  expect_nonobtuse(task);
}

TEST(FillDisks, NothingIsObtuseInClearancesDownTo1e5) {
  for (const double gap : {1e-2, 1e-4, 1e-5}) {
    SCOPED_TRACE(gap);
    expect_nonobtuse(boundary_of({square(0, 0, 1), reversed(square(0.3, gap, 0.4))}));
  }
}

TEST(FillDisks, TinyClearancesAreValidAndListed) {
  for (const double gap : {1e-6, 1e-8}) {
    SCOPED_TRACE(gap);
    const FillTask task =
        testing::task_of(boundary_of({square(0, 0, 1), reversed(square(0.3, gap, 0.4))}));
    const Filling filling = make_disk_filler()->fill(task, {});
    const FillingFacts facts = testing::check_filling(task, filling);
    EXPECT_EQ(facts.fault, "");
    EXPECT_EQ(filling.target_reached, facts.largest_angle <= kLargestSnapped);
    EXPECT_EQ(filling.remark.empty(), filling.target_reached);
  }
}

TEST(FillDisks, NothingIsObtuseInNeedles) {
  for (const double width : {1e-1, 1e-2, 1e-3}) {
    SCOPED_TRACE(width);
    expect_nonobtuse(boundary_of({{{0, 0}, {1, 0}, {1, width}}}));
  }
}

/// The tasks of the transformation tests.
RegionBoundary star_with_hole(double scale, Point shift) {
  std::mt19937_64 random(5);
  Loop outer = testing::random_star(20, 0.5, random), hole = regular_polygon(7, 0.25);
  for (Loop* loop : {&outer, &hole}) {
    for (Point& p : *loop) {
      // On a coarse grid, so that shifting is exact.
      p = {std::ldexp(std::round(std::ldexp(p.x, 20)), -20) * scale + shift.x,
           std::ldexp(std::round(std::ldexp(p.y, 20)), -20) * scale + shift.y};
    }
  }
  return boundary_of({outer, reversed(hole)});
}

TEST(FillDisks, ScalingByAPowerOfTwoScalesTheMesh) {
  const FillTask task = testing::task_of(star_with_hole(1, {}));
  const Filling one = make_disk_filler()->fill(task, {});
  for (const double scale : {0x1p-30, 0x1p+40}) {
    const Filling scaled =
        make_disk_filler()->fill(testing::task_of(star_with_hole(scale, {})), {});
    ASSERT_EQ(scaled.triangles, one.triangles);
    for (std::size_t k = 0; k < one.added.size(); ++k) {
      EXPECT_EQ(scaled.added[k].x, one.added[k].x * scale);
      EXPECT_EQ(scaled.added[k].y, one.added[k].y * scale);
    }
  }
}

TEST(FillDisks, AnExactShiftKeepsTheConnectivity) {
  const Filling one = make_disk_filler()->fill(testing::task_of(star_with_hole(1, {})), {});
  const FillTask far = testing::task_of(star_with_hole(1, {0x1p+20, -0x1p+20}));
  EXPECT_EQ(make_disk_filler()->fill(far, {}).triangles, one.triangles);
  expect_nonobtuse(far);
}

TEST(FillDisks, RefusesLockedChordsAndSlitsWithAValidTriangulation) {
  FillTask task = testing::task_of(boundary_of({square(0, 0, 1)}));
  task.chords[2].locked = true;
  Filling filling = make_disk_filler()->fill(task, {});
  EXPECT_FALSE(filling.target_reached);
  EXPECT_NE(filling.remark, "");
  EXPECT_EQ(testing::check_filling(task, filling).fault, "");
  EXPECT_TRUE(filling.splits.empty());

  task = testing::task_of(boundary_of({square(0, 0, 4), {{1, 1}, {3, 2}}}));
  filling = make_disk_filler()->fill(task, {});
  EXPECT_FALSE(filling.target_reached);
  EXPECT_FALSE(filling.triangles.empty());

  task.points = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};  // crossing chords
  task.chords = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  EXPECT_TRUE(make_disk_filler()->fill(task, {}).triangles.empty());
}

/// A random star with random star-shaped holes and isolated points.
RegionBoundary random_region(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const int n = 3 + static_cast<int>(uniform(random) * 40);
  const double smallest = 0.1 + 0.8 * uniform(random);
  std::vector<Loop> loops{testing::random_star(n, smallest, random)};
  std::vector<Point> isolated;
  const int holes = n < 5 ? 0 : static_cast<int>(uniform(random) * 5);
  const double inner = 0.95 * smallest * std::cos(std::numbers::pi / n);  // a free disk
  for (int k = 0; k < holes; ++k) {
    const double t = 2 * std::numbers::pi * k / holes + 0.3;
    const Point c{0.55 * inner * std::cos(t), 0.55 * inner * std::sin(t)};
    const double room = 0.45 * inner * std::sin(std::numbers::pi / std::max(holes, 2));
    if (uniform(random) < 0.3) {
      isolated.push_back(c);
    } else {
      const int corners = 3 + static_cast<int>(uniform(random) * 8);
      loops.push_back(reversed(
          testing::random_star(corners, 0.3, random, c, room * (0.05 + 0.95 * uniform(random)))));
    }
  }
  return boundary_of(loops, isolated);
}

/// COVER_DISK_REGIONS says how many.
TEST(FillDisks, RandomRegions) {
  const std::uint64_t count = testing::cases_asked_for("COVER_DISK_REGIONS", 200);
  const std::uint64_t first = testing::test_seed(0);
  std::size_t vertices = 0, filled = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(testing::seed_trace(seed));
    std::mt19937_64 random(seed);
    const RegionBoundary boundary = random_region(random);
    vertices += boundary.points.size();
    filled += expect_nonobtuse(boundary).vertices;
    if (HasFailure()) break;
  }
  EXPECT_LE(filled, 30 * vertices);
}

}  // namespace
}  // namespace cover
