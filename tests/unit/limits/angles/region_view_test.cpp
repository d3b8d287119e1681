#include "limits/angles/region_view.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "cdt/cdt.hpp"
#include "support/inputs/random_regions.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(RegionView, CornersOfASquare) {
  const RegionBoundary square = boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const Triangulation cdt = triangulate_domain(square.points, square.sides).triangulation;
  const RegionView view(cdt);
  ASSERT_EQ(view.sides().size(), 4U);
  for (const RegionSide& side : view.sides()) {
    const RegionCorner &start = view.corner(side.start), &end = view.corner(side.end);
    EXPECT_EQ(start.vertex, side.a);
    EXPECT_EQ(end.vertex, side.b);
    EXPECT_NEAR(start.angle, std::numbers::pi / 2, 1e-15);
    EXPECT_EQ(view.seen_from(start).front().vertex, side.b);
    EXPECT_EQ(view.seen_from(end).back().vertex, side.a);
  }
}

double bend_of(const RegionBoundary& boundary) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  return RegionView(cdt).bend();
}

TEST(RegionView, BendIsWhatIsMissingToConvex) {
  EXPECT_EQ(bend_of(boundary_of({{{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}}})), 0);
  EXPECT_NEAR(bend_of(boundary_of({{{0, 0}, {0.5, 1e-6}, {1, 0}, {1, 1}, {0, 1}}})), 4e-6, 1e-11);
  EXPECT_NEAR(bend_of(boundary_of({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}})),
              std::numbers::pi / 2, 1e-11);
  const RegionBoundary with_point = boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {{0.3, 0.4}});
  EXPECT_TRUE(std::isinf(bend_of(with_point)));
  const RegionBoundary with_hole =
      boundary_of({{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, reversed(regular_polygon(3, 1))});
  EXPECT_TRUE(std::isinf(bend_of(with_hole)));
}

TEST(RegionView, CornersFillTheAnglesOfTheTriangles) {
  std::mt19937_64 random(test_seed(5));
  for (int k = 0; k < 300; ++k) {
    const RandomRegion region = random_region(random);
    const Triangulation cdt =
        triangulate_domain(region.boundary.points, region.boundary.sides).triangulation;
    const RegionView view(cdt);
    ASSERT_EQ(view.sides().size(), region.boundary.sides.size()) << region.kind;
    double sum = 0;
    for (const RegionSide& side : view.sides()) {
      EXPECT_EQ(view.corner(side.start).vertex, side.a);
      EXPECT_EQ(view.corner(side.end).vertex, side.b);
      EXPECT_LE(view.corner(side.start).angle, 2 * std::numbers::pi + 1e-9);
      sum += view.corner(side.start).angle;
    }
    // Around a vertex on no side the angles add up to a full turn.
    std::vector<bool> on_side(cdt.points.size());
    for (const RegionSide& side : view.sides()) on_side[side.a] = true;
    std::vector<bool> used(cdt.points.size());
    for (const Triangle& f : cdt.triangles) {
      for (const std::uint32_t v : f.v) used[v] = true;
    }
    for (std::size_t v = 0; v < used.size(); ++v) {
      if (used[v] && !on_side[v]) sum += 2 * std::numbers::pi;
    }
    const double expected = std::numbers::pi * static_cast<double>(cdt.triangles.size());
    EXPECT_NEAR(sum, expected, 1e-6 * expected) << region.kind;
  }
}

}  // namespace
}  // namespace cover
