#include "covering/disks/fill_disks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "support/filling_checks.hpp"
#include "support/shapes.hpp"

namespace cover {
namespace {

using testing::boundary_of;
using testing::FillingFacts;
using testing::Loop;
using testing::regular_polygon;
using testing::reversed;

/// Fills a region and expects a nonobtuse result without a second attempt.
FillingFacts expect_nonobtuse(const RegionBoundary& boundary) {
  const FillTask task = testing::task_of(boundary);
  PackingRecord record;
  const Filling filling = make_disk_filler(&record)->fill(task, {});
  const FillingFacts facts = testing::check_filling(task, filling);
  EXPECT_EQ(facts.fault, "");
  EXPECT_TRUE(filling.target_reached) << filling.remark;
  EXPECT_LE(facts.largest_angle, kLargestSnapped);
  EXPECT_EQ(record.attempts, 1);
  return facts;
}

Loop square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

TEST(FillDisks, SquareAndL) {
  FillingFacts facts = expect_nonobtuse(boundary_of({square(0, 0, 1)}));
  EXPECT_EQ(facts.triangles, 64U);
  EXPECT_EQ(facts.vertices, 41U);
  facts = expect_nonobtuse(boundary_of({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}));
  EXPECT_LE(facts.vertices, 140U);
}

TEST(FillDisks, RegularPolygons) {
  for (int n = 3; n <= 32; ++n) {
    SCOPED_TRACE(n);
    const FillingFacts facts = expect_nonobtuse(boundary_of({regular_polygon(n)}));
    EXPECT_LE(facts.triangles, static_cast<std::size_t>(30 * n));
  }
}

TEST(FillDisks, HolesInAGrid) {
  std::vector<Loop> loops{square(0, 0, 11)};
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) loops.push_back(reversed(square(1 + 2 * i, 1 + 2 * j, 1)));
  }
  const FillingFacts facts = expect_nonobtuse(boundary_of(loops));
  EXPECT_LE(facts.triangles, 85U * 104U);
}

}  // namespace
}  // namespace cover
