#include "layers/front/layer_front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cdt/region_cdt.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "layers/front/side_links.hpp"
#include "target/report/measure_angles.hpp"

namespace cover::layers {
namespace {

/// A region with these loops, the region on the left of each; sides from `layered` points on (by
/// their loop and place in it) have rule 1.
struct Drawing {
  RegionBoundary boundary;

  void add(const std::vector<Point>& loop, const std::vector<bool>& layered) {
    const auto first = static_cast<std::uint32_t>(boundary.points.size());
    const auto n = static_cast<std::uint32_t>(loop.size());
    std::vector<std::pair<IndexPair, std::uint32_t>> sides;
    for (std::size_t s = 0; s < boundary.sides.size(); ++s)
      sides.push_back({boundary.sides[s], boundary.layers[s]});
    for (std::uint32_t k = 0; k < n; ++k) {
      boundary.points.push_back(loop[k]);
      sides.push_back({{first + k, first + (k + 1) % n}, layered[k] ? 1U : 0U});
    }
    std::sort(sides.begin(), sides.end());
    boundary.sides.clear();
    boundary.layers.clear();
    for (const auto& [side, rule] : sides) {
      boundary.sides.push_back(side);
      boundary.layers.push_back(rule);
    }
    boundary.segments.assign(sides.size(), SegmentId{0U});
  }
};

LayerFront lay(const RegionBoundary& boundary, const std::vector<LayerRule>& rules,
               const std::vector<int>& most) {
  LayerFront front(boundary, rules, most);
  front.lay();
  return front;
}

struct Laid {
  explicit Laid(const RegionBoundary& boundary, const LayerRule& rule)
      : rules{rule},
        most(boundary.sides.size(), std::numeric_limits<int>::max()),
        front(lay(boundary, rules, most)),
        points(boundary.points) {
    points.insert(points.end(), front.added().begin(), front.added().end());
    quality = measure_angles(points, front.triangles());
  }
  /// Whether the front bounds a region.
  [[nodiscard]] bool is_simple() const {
    std::vector<IndexPair> sides;
    for (const auto& [a, b, side] : front.front()) sides.push_back({a, b});
    std::sort(sides.begin(), sides.end());
    std::vector<std::uint32_t> used;
    for (const auto& [a, b] : sides) used.push_back(a);
    std::sort(used.begin(), used.end());
    const CdtResult cdt = triangulate_domain(points, sides);
    return cdt.conflicts.empty() && std::unique(used.begin(), used.end()) == used.end();
  }

  std::vector<LayerRule> rules;
  std::vector<int> most;
  LayerFront front;
  std::vector<Point> points;
  Quality quality;
};

/// A box of width w, whose bottom is cut into n.
Drawing box(int n, double w, double h) {
  std::vector<Point> loop;
  std::vector<bool> layered;
  for (int k = 0; k < n; ++k) {
    loop.push_back({w * k / n, 0});
    layered.push_back(true);
  }
  for (const Point& p : {Point{w, 0}, Point{w, h}, Point{0, h}}) {
    loop.push_back(p);
    layered.push_back(false);
  }
  Drawing drawing;
  drawing.add(loop, layered);
  return drawing;
}

TEST(LayerFront, TapersOffTowardsWallsThatMayNotBeCut) {
  const Drawing drawing = box(10, 10, 5);
  const Laid laid(drawing.boundary, {"", "", 0.001, 2, 3});
  EXPECT_TRUE(laid.is_simple());
  EXPECT_LE(laid.quality.largest_nu.supplement().in_degrees(), 90.3);
  // All rows end in the corners, with a triangle each over the last segments.
  EXPECT_EQ(laid.front.triangles().size(), 3 * (2 * 8 + 2U));
  const auto& sides = laid.front.sides();
  for (std::uint32_t s = 0; s < 10; ++s) {
    const bool last = s == 0 || s == 9;
    EXPECT_EQ(sides[s].rows, last ? 0 : 3) << s;
    EXPECT_EQ(sides[s].stop, last ? LayerStop::end : LayerStop::none) << s;
  }
  std::vector<double> heights;
  for (const Point& p : laid.front.added()) heights.push_back(p.y);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  EXPECT_EQ(heights, (std::vector<double>{0.001, 0.003, 0.007}));
}

TEST(LayerFront, StepsDownOneSegmentPerRowWhereRowsAreThick) {
  const Drawing drawing = box(10, 10, 50);
  const Laid laid(drawing.boundary, {"", "", 0.5, 1.01, 3});
  EXPECT_TRUE(laid.is_simple());
  EXPECT_LE(laid.quality.largest_nu.supplement().in_degrees(), 90 + 1e-9);
  // Row k has k - 1 edges less on either side; its cells at both ends are triangles.
  EXPECT_EQ(laid.front.triangles().size(), 2 * (10 + 8 + 6) - 2 * 3U);
  for (std::uint32_t s = 0; s < 10; ++s) {
    const int from_end = static_cast<int>(std::min(s, 9 - s));
    EXPECT_EQ(laid.front.sides()[s].rows, std::min(from_end, 3)) << s;
  }
}

TEST(LayerFront, GoesRoundInMitresOfInnerCorners) {
  for (const int n : {18, 12, 9, 6, 5}) {  // 20, 30, 40, 60 and 72 degrees
    SCOPED_TRACE(n);
    std::vector<Point> loop;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n;
      loop.push_back({3 * std::cos(angle), 3 * std::sin(angle)});
    }
    Drawing drawing;
    drawing.add(loop, std::vector<bool>(loop.size(), true));
    const Laid laid(drawing.boundary, {"", "", 0.01, 1.5, 4});
    const auto corners = static_cast<std::size_t>(n);
    EXPECT_EQ(laid.front.triangles().size(), 2 * 4 * corners);
    EXPECT_EQ(laid.front.added().size(), 4 * corners);
    for (const SideLayers& side : laid.front.sides()) EXPECT_EQ(side.rows, 4);
    EXPECT_TRUE(laid.is_simple());
    EXPECT_LE(laid.quality.largest_nu.supplement().in_degrees(), 90 + 180.0 / n + 1e-6);
  }
}

/// Right triangles fill the mitres where sides have the feet of the vertices there.
TEST(LayerFront, ClosesCellsAtTheFeetOfMitres) {
  for (const int n : {12, 6, 5}) {
    SCOPED_TRACE(n);
    const double half = std::numbers::pi / n;
    std::vector<Point> loop;
    for (int k = 0; k < n; ++k) {
      const auto corner = [&](int i) {
        return Point{3 * std::cos(2 * half * i), 3 * std::sin(2 * half * i)};
      };
      const Point a = corner(k), b = corner(k + 1);
      const Vector unit = (1 / length(b - a)) * (b - a);
      loop.push_back(a);
      for (const double away : {0.01, 0.025, 0.0475})
        loop.push_back(a + std::tan(half) * away * unit);
      for (const double away : {0.0475, 0.025, 0.01})
        loop.push_back(b + (-std::tan(half) * away) * unit);
    }
    Drawing drawing;
    drawing.add(loop, std::vector<bool>(loop.size(), true));
    const Laid laid(drawing.boundary, {"", "", 0.01, 1.5, 3});
    EXPECT_TRUE(laid.is_simple());
    EXPECT_LE(laid.quality.largest_nu.supplement().in_degrees(), 90 + 1e-6);
    for (const SideLayers& side : laid.front.sides())
      EXPECT_TRUE(side.stop == LayerStop::corner ||
                  (side.stop == LayerStop::none && side.rows == 3));
    // One vertex per row and corner in the mitre, and those over feet of further rows.
    EXPECT_EQ(laid.front.added().size(), static_cast<std::size_t>(n) * (5 + 3 + 1));
    EXPECT_EQ(laid.front.front().size(), static_cast<std::size_t>(n));
  }
}

/// Their triangles have no upper edge left, where rows are too thick for short edges beside them.
TEST(LayerFront, EndsInMitresThatEdgesAreTooShortFor) {
  Drawing drawing;
  drawing.add({{0, 0}, {2, 0}, {2.04, 0}, {2.06, 0.04}, {3, 2}, {0, 2}},
              {true, true, true, true, false, false});
  const Laid laid(drawing.boundary, {"", "", 0.02, 1.5, 6});
  EXPECT_TRUE(laid.is_simple());
  EXPECT_LT(laid.front.sides()[1].rows, 6);
  EXPECT_LE(laid.quality.largest_nu.supplement().in_degrees(), 130);
}

TEST(LayerFront, RunsUpToWallsWithVerticesAtItsHeights) {
  Drawing drawing;
  drawing.add(
      {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 0.1}, {3, 0.3}, {3, 2}, {0, 2}, {0, 0.3}, {0, 0.1}},
      {true, true, true, false, false, false, false, false, false, false});
  const Laid laid(drawing.boundary, {"", "", 0.1, 2, 2});
  EXPECT_EQ(laid.front.triangles().size(), 2 * 3 * 2U);
  EXPECT_EQ(laid.front.added().size(), 2 * 2U);
  EXPECT_LE(laid.quality.largest_nu.supplement().in_degrees(), 90 + 1e-9);
  EXPECT_EQ(laid.front.front().size(), 3 + 3U);
  EXPECT_TRUE(laid.is_simple());
}

TEST(LayerFront, MakesATensorGridInACornerOfTwoLines) {
  // Both lines are cut at 0.1 and 0.3.
  Drawing drawing;
  drawing.add(
      {{0, 0}, {0.1, 0}, {0.3, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}, {0, 0.3}, {0, 0.1}},
      {true, true, true, true, false, false, true, true, true, true});
  const Laid laid(drawing.boundary, {"", "", 0.1, 2, 2});
  EXPECT_TRUE(laid.is_simple());
  std::vector<IndexTriple> block;  // rows taper off at the other ends
  for (const IndexTriple& t : laid.front.triangles()) {
    if (std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
          return laid.points[v].x <= 1 && laid.points[v].y <= 1;
        }))
      block.push_back(t);
  }
  EXPECT_GE(block.size(), 2 * 2 * 2U);
  EXPECT_LE(measure_angles(laid.points, block).largest_nu.supplement().in_degrees(), 90 + 1e-9);
  for (const Point& p : {Point{0.1, 0.1}, Point{0.3, 0.1}, Point{0.1, 0.3}, Point{0.3, 0.3}}) {
    EXPECT_EQ(std::count_if(laid.points.begin(), laid.points.end(),
                            [&](Point q) { return length(q - p) < 1e-12; }),
              1);
  }
}

TEST(LayerFront, ClosesAroundAnIslandWithSquaresAtItsCorners) {
  Drawing drawing;
  drawing.add({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {false, false, false, false});
  drawing.add({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}, {true, true, true, true});
  const Laid laid(drawing.boundary, {"", "", 0.01, 1.5, 3});
  EXPECT_TRUE(laid.is_simple());
  EXPECT_NEAR(laid.quality.largest_nu.supplement().in_degrees(), 90, 1e-9);
  // Each row has a square in each corner, and one cell more on either side per row before.
  EXPECT_EQ(laid.front.triangles().size(), 2 * 4 * (1 + 1 + 3 + 1 + 5 + 1U));
  for (std::uint32_t s = 4; s < 8; ++s) EXPECT_EQ(laid.front.sides()[s].rows, 3);
}

TEST(LayerFront, FollowsACircleOnBothSides) {
  std::vector<Point> circle;
  constexpr int kChords = 40;
  for (int k = 0; k < kChords; ++k) {
    const double angle = 2 * std::numbers::pi * k / kChords;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  const LayerRule rule{"", "", 0.001, 1.3, 0};
  Drawing inside;
  inside.add(circle, std::vector<bool>(kChords, true));
  const Laid within(inside.boundary, rule);
  EXPECT_TRUE(within.is_simple());
  EXPECT_LE(within.quality.largest_nu.supplement().in_degrees(), 95);
  std::reverse(circle.begin(), circle.end());
  Drawing outside;
  outside.add({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {false, false, false, false});
  outside.add(circle, std::vector<bool>(kChords, true));
  const Laid around(outside.boundary, rule);
  EXPECT_TRUE(around.is_simple());
  EXPECT_LE(around.quality.largest_nu.supplement().in_degrees(), 95);
  for (const Laid* laid : {&within, &around}) {
    for (std::uint32_t s = 0; s < laid->front.sides().size(); ++s) {
      if (laid == &around && s < 4) continue;
      EXPECT_GT(laid->front.sides()[s].rows, 10);
      EXPECT_EQ(laid->front.sides()[s].stop, LayerStop::isotropic);
    }
  }
}

TEST(LayerFront, LinesThatFaceEachOtherShareTheRoom) {
  std::vector<Point> loop;
  for (int k = 0; k <= 20; ++k) loop.push_back({k * 1.0, 0});
  for (int k = 20; k >= 0; --k) loop.push_back({k * 1.0, 1});
  std::vector<bool> layered(loop.size(), true);
  layered[20] = layered[41] = false;
  Drawing drawing;
  drawing.add(loop, layered);
  const Laid laid(drawing.boundary, {"", "", 0.1, 1, 50});
  EXPECT_TRUE(laid.is_simple());
  for (std::uint32_t s = 5; s < 15; ++s) {
    EXPECT_EQ(laid.front.sides()[s].rows, laid.front.sides()[s + 21].rows) << s;
    EXPECT_EQ(laid.front.sides()[s].rows, 4) << s;
    EXPECT_EQ(laid.front.sides()[s].stop, LayerStop::room) << s;
  }
}

TEST(LayerFront, KeepsAwayFromIsolatedPoints) {
  Drawing drawing = box(10, 10, 5);
  drawing.boundary.points.push_back({5.5, 0.2});
  const Laid laid(drawing.boundary, {"", "", 0.1, 1, 4});
  EXPECT_TRUE(laid.is_simple());
  EXPECT_EQ(laid.front.sides()[5].rows, 1);
  EXPECT_EQ(laid.front.sides()[5].stop, LayerStop::room);
  EXPECT_EQ(laid.front.sides()[3].stop, LayerStop::end);
  for (const auto& t : laid.front.triangles()) {
    bool outside = false;
    for (std::size_t k = 0; k < 3; ++k)
      outside |=
          orientation(laid.points[t[k]], laid.points[t[(k + 1) % 3]], {5.5, 0.2}) != Sign::positive;
    EXPECT_TRUE(outside);
  }
}

TEST(LayerFront, GoesRoundASlit) {
  Drawing drawing;
  drawing.add({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {false, false, false, false});
  RegionBoundary& boundary = drawing.boundary;
  boundary.points.insert(boundary.points.end(), {{-1, 0}, {0, 0}, {1, 0}});
  for (const IndexPair& side : {IndexPair{4, 5}, IndexPair{5, 4}, IndexPair{5, 6}, IndexPair{6, 5}})
    boundary.sides.push_back(side);
  boundary.layers.assign(8, 1);
  std::fill_n(boundary.layers.begin(), 4, 0);
  const Laid laid(boundary, {"", "", 0.01, 1.5, 4});
  EXPECT_TRUE(laid.is_simple());
  EXPECT_NEAR(laid.quality.largest_nu.supplement().in_degrees(), 90, 1e-9);
  for (std::uint32_t s = 4; s < 8; ++s) EXPECT_EQ(laid.front.sides()[s].rows, 4);
}

TEST(NextSides, TurnAroundVerticesOfSeveralSectors) {
  // Two triangles that touch in the origin, and the void between them.
  RegionBoundary boundary;
  boundary.points = {{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}};
  boundary.sides = {{0, 1}, {0, 3}, {1, 2}, {2, 0}, {3, 4}, {4, 0}};
  EXPECT_EQ(next_sides(boundary), (std::vector<std::uint32_t>{2, 4, 3, 0, 5, 1}));
}

}  // namespace
}  // namespace cover::layers
