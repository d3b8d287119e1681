#include "region/whole_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/run_all.hpp"
#include "cdt/cdt.hpp"
#include "cdt/couplings.hpp"
#include "geom/vector.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

/// A region, and its constrained Delaunay triangulation as bare triangles.
struct Region {
  RegionBoundary boundary;
  std::vector<Point> points;
  std::vector<IndexTriple> triangles;

  explicit Region(RegionBoundary of) : boundary(std::move(of)), points(boundary.points) {
    for (const Triangle& t : triangulate_domain(points, boundary.sides).triangulation.triangles)
      triangles.push_back(t.v);
  }
  [[nodiscard]] std::string flaw() const {
    const auto found =
        find_flaw({points, triangles, boundary.sides, boundary.segments, boundary.points.size()});
    return found ? found->what : "";
  }
};

Region square() {
  return Region(
      testing::boundary_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 2}}}, {{1, 3}}));
}

TEST(WholeMesh, FindsNothingWhereAllIsThere) { EXPECT_EQ(square().flaw(), ""); }

TEST(WholeMesh, TellsWhatLiesAcrossEdges) {
  const Region region = square();  // with a slit, which has triangles on both sides
  const auto& sides = region.boundary.sides;
  std::vector<std::uint32_t> across;
  EXPECT_FALSE(find_flaw({region.points, region.triangles, sides, region.boundary.segments,
                          region.boundary.points.size()},
                         {}, &across));
  EXPECT_EQ(across, across_edges(region.points.size(), region.triangles, sides));
}

/// More triangles than one thread takes for itself, and flaws at several places: the first counts.
TEST(WholeMesh, FindsTheSameByAnyNumberOfThreads) {
  constexpr std::uint32_t n = 200;
  std::vector<Point> points;
  std::vector<IndexTriple> grid;
  const auto at = [](std::uint32_t x, std::uint32_t y) { return (n + 1) * y + x; };
  for (std::uint32_t v = 0; v < (n + 1) * (n + 1); ++v)
    points.push_back({static_cast<double>(v % (n + 1)), static_cast<double>(v / (n + 1))});
  for (std::uint32_t k = 0; k < n * n; ++k) {
    const std::uint32_t x = k % n, y = k / n;
    grid.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
    grid.push_back({at(x, y + 1), at(x + 1, y), at(x + 1, y + 1)});
  }
  std::vector<IndexPair> sides;
  for (std::uint32_t k = 0; k < n; ++k) {
    sides.push_back({at(k, 0), at(k + 1, 0)});
    sides.push_back({at(n, k), at(n, k + 1)});
    sides.push_back({at(k + 1, n), at(k, n)});
    sides.push_back({at(0, k + 1), at(0, k)});
  }
  std::sort(sides.begin(), sides.end());
  const std::vector<SegmentId> segments(sides.size(), SegmentId(1));
  const auto flaw = [&](std::vector<IndexTriple> triangles, std::size_t given, const Team& team) {
    const auto found = find_flaw({points, triangles, sides, segments, given}, team);
    return found ? found->what : "";
  };
  std::vector<IndexTriple> turned = grid, doubled = grid, open = grid;
  for (const std::size_t t : {79'000U, 70'001U, 70'003U}) std::swap(turned[t][0], turned[t][1]);
  doubled.push_back(grid[41]);
  open.erase(open.begin() + 70'000, open.begin() + 70'010);
  points.push_back({-1, -1});
  const std::size_t given = points.size();
  for (const auto& [triangles, lost] :
       {std::pair(grid, 0U), std::pair(turned, 0U), std::pair(doubled, 0U), std::pair(open, 0U),
        std::pair(grid, 1U)}) {
    const std::string alone = flaw(triangles, given - 1 + lost, Team());
    EXPECT_EQ(alone.empty(), triangles == grid && lost == 0);
    for (const unsigned workers : {2U, 3U, 7U}) {
      with_team(workers, [&, &triangles = triangles, &lost = lost](const Team& team) {
        EXPECT_EQ(flaw(triangles, given - 1 + lost, team), alone);
      });
    }
  }
}

TEST(WholeMesh, FindsEveryKindOfDamage) {
  Region region = square();
  for (std::size_t t = 0; t < region.triangles.size(); ++t) {
    Region less = region;
    less.triangles.erase(less.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    EXPECT_NE(less.flaw(), "") << t;
    Region twice = region;
    twice.triangles.push_back(twice.triangles[t]);
    EXPECT_NE(twice.flaw(), "") << t;
    Region turned = region;
    std::swap(turned.triangles[t][0], turned.triangles[t][1]);
    EXPECT_NE(turned.flaw(), "") << t;
  }
  Region lost = region;
  lost.boundary.points.push_back({2, 3});  // as if it were a point of the boundary
  lost.points.push_back({2, 3});
  EXPECT_NE(lost.flaw().find("(2, 3)"), std::string::npos);
  Region empty = region;
  empty.triangles.clear();
  EXPECT_NE(empty.flaw(), "");
  // One that is a side from one of its two sides only.
  Region half = region;
  const auto slit =
      std::find_if(half.boundary.sides.begin(), half.boundary.sides.end(), [&](const IndexPair& s) {
        return half.points[s[0]] == Point{1, 1} && half.points[s[1]] == Point{3, 2};
      });
  ASSERT_NE(slit, half.boundary.sides.end());
  half.boundary.segments.erase(half.boundary.segments.begin() +
                               (slit - half.boundary.sides.begin()));
  half.boundary.sides.erase(slit);
  EXPECT_NE(half.flaw(), "");
}

TEST(WholeMesh, SidesOfTheHullMayBeSplit) {
  Region region(testing::boundary_of({{{0, 0}, {4, 0}, {0, 4}}}));
  ASSERT_EQ(region.triangles.size(), 1U);
  const IndexTriple t = region.triangles[0];
  region.points.push_back(midpoint(region.points[t[0]], region.points[t[1]]));
  region.triangles = {{t[0], 3, t[2]}, {3, t[1], t[2]}};
  EXPECT_NE(region.flaw(), "");
  std::fill(region.boundary.segments.begin(), region.boundary.segments.end(), kHullSide);
  EXPECT_EQ(region.flaw(), "");
  const Point middle = region.points[3];
  region.points[3] = middle + 0x1p-20 * (region.points[t[2]] - middle);
  EXPECT_NE(region.flaw(), "");  // no longer on the side
  region.points[3] = middle;
  region.triangles.pop_back();
  EXPECT_NE(region.flaw(), "");
}

}  // namespace
}  // namespace cover
