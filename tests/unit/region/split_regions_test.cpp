#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/run_all.hpp"
#include "cdt/cdt.hpp"
#include "clean/pslg.hpp"
#include "geom/spatial_order.hpp"
#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

std::vector<RegionBoundary> split(const Input& input, const Options& options = {}) {
  Report report;
  const auto pslg = make_pslg(input, options, report);
  if (!pslg) throw std::runtime_error(pslg.error().message);
  const auto table = build_region_table(*pslg, options, report.notes);
  if (!table) throw std::runtime_error(table.error().message);
  const auto out = split_regions(*pslg, *table);
  for (const RegionBoundary& b : out) {
    std::vector<Point> ascending = b.points;
    std::sort(ascending.begin(), ascending.end());
    const std::vector<std::uint32_t> order = spatial_order(ascending);
    for (std::size_t k = 0; k < order.size(); ++k) EXPECT_EQ(b.points[k], ascending[order[k]]);
    EXPECT_TRUE(std::is_sorted(b.sides.begin(), b.sides.end()));
    EXPECT_EQ(b.sides.size(), b.segments.size());
    EXPECT_EQ(b.sides.size(), table->region(b.id).sides);
    EXPECT_NEAR(testing::area_of(b), table->region(b.id).area, 1e-12);
    for (std::size_t k = 0; k < b.points.size(); ++k) {
      EXPECT_EQ(b.points[k], pslg->points[b.vertices[k].index()]);
    }
  }
  return out;
}

/// A square from 0 to 4 with a slit that hangs on its left side, a slit of its own, a triangle
/// that touches its border in one point, and an isolated point.
Input busy_square() {
  return testing::segments_between(
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 0.5}, {2, 2}, {3, 2}, {3, 3}, {2, 4 - 0.5}, {1, 3}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {5, 6}, {2, 7}, {7, 8}, {8, 2}});
}

TEST(SplitRegions, GivesSlitsBothWaysAndIsolatedPoints) {
  const auto boundaries = split(busy_square());
  ASSERT_EQ(boundaries.size(), 2U);
  const RegionBoundary& outer = boundaries[0];
  EXPECT_EQ(outer.points.size(), 10U);
  EXPECT_EQ(outer.sides.size(), 4U + 2 + 2 + 3);
  EXPECT_EQ(std::count(outer.segments.begin(), outer.segments.end(), SegmentId{5}), 2);
  EXPECT_EQ(boundaries[1].sides.size(), 3U);
  for (const RegionBoundary& b : boundaries) {
    EXPECT_TRUE(triangulate_domain(b.points, b.sides).conflicts.empty());
  }
}

TEST(SplitRegions, DependsOnGeometryAlone) {
  const Input input = testing::checker(5, 4, 2);
  Input other_order = testing::shuffled(input, 7);
  other_order.seeds = input.seeds;  // whose order is that of the regions
  const auto base = split(input), mixed = split(other_order);
  ASSERT_EQ(base.size(), 25U);
  ASSERT_EQ(mixed.size(), base.size());
  for (std::size_t k = 0; k < base.size(); ++k) {
    EXPECT_EQ(base[k].points, mixed[k].points);
    EXPECT_EQ(base[k].sides, mixed[k].sides);
  }
}

TEST(SplitRegions, MarksHullSides) {
  Input input;
  input.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  input.segments.resize(1);
  input.segments[0].b = 4;
  Options hull;
  hull.hull = true;
  const auto boundaries = split(input, hull);
  ASSERT_EQ(boundaries.size(), 1U);
  EXPECT_EQ(boundaries[0].sides.size(), 6U);
  EXPECT_EQ(std::count(boundaries[0].segments.begin(), boundaries[0].segments.end(), kHullSide), 4);
}

/// A disk in a ring, with many points, and the triangles that are known of the ring.
TEST(SplitRegions, IsTheSameForAnyNumberOfThreads) {
  constexpr std::uint32_t kPoints = 30'000;
  Input input;
  for (std::uint32_t ring = 1; ring <= 2; ++ring) {
    const auto first = static_cast<std::uint32_t>(input.points.size());
    for (std::uint32_t k = 0; k < kPoints; ++k) {
      const double turn = 2 * 3.14159265358979 * k / kPoints;
      input.points.push_back({ring * std::cos(turn), ring * std::sin(turn)});
      input.segments.push_back({first + k, first + (k + 1) % kPoints, 0, k, 0, ""});
    }
  }
  input.points.push_back({0.25, 0.5});
  const auto made = [&](const Team& team) {
    Report report;
    std::optional<Triangulation> whole;
    const auto pslg = make_pslg(input, {}, report, &whole, team);
    std::vector<Note> notes;
    auto found = build_triangulated_table(*pslg, {}, notes, std::move(whole), team);
    std::vector<RegionBoundary> all = split_regions(*pslg, found->table, team);
    add_known_triangles(found->triangulated, pslg->points.size(), all, team);
    return all;
  };
  const std::vector<RegionBoundary> alone = made(Team());
  ASSERT_EQ(alone.size(), 2U);
  std::size_t known = 0;
  for (const RegionBoundary& b : alone) known += b.known_triangles().size();
  EXPECT_EQ(known, 3 * kPoints);
  for (const unsigned workers : {2U, 3U, 7U}) {
    with_team(workers, [&](const Team& team) {
      const std::vector<RegionBoundary> all = made(team);
      ASSERT_EQ(all.size(), alone.size());
      for (std::size_t r = 0; r < all.size(); ++r) {
        EXPECT_EQ(all[r].points, alone[r].points);
        EXPECT_EQ(all[r].vertices, alone[r].vertices);
        EXPECT_EQ(all[r].sides, alone[r].sides);
        EXPECT_EQ(all[r].segments, alone[r].segments);
        EXPECT_TRUE(std::ranges::equal(all[r].known_triangles(), alone[r].known_triangles()));
      }
    });
  }
}

}  // namespace
}  // namespace cover
