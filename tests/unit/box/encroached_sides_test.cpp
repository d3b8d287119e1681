#include "box/encroached_sides.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cdt/cdt.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

std::vector<EncroachedSide> encroached(const RegionBoundary& boundary) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  return encroached_sides(cdt, locate_sides(cdt, boundary.sides));
}

TEST(EncroachedSides, ARightAngleIsNone) {
  EXPECT_TRUE(encroached(testing::boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}})).empty());
  EXPECT_TRUE(encroached(testing::boundary_of({{{0, 0}, {4, 0}, {0, 3}}})).empty());
}

TEST(EncroachedSides, OneUnitInTheLastPlaceInsideIsOne) {
  const double inside = std::nextafter(1.0, 0.0);
  const RegionBoundary boundary = testing::boundary_of({{{-1, 0}, {1, 0}, {0, inside}}});
  const auto found = encroached(boundary);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(boundary.points[found[0].vertex], (Point{0, inside}));
  EXPECT_TRUE(encroached(testing::boundary_of({{{-1, 0}, {1, 0}, {0, 1}}})).empty());
}

TEST(EncroachedSides, WhatCannotBeSeenDoesNotCount) {
  const testing::Loop box{{-4, 0}, {-1, 0}, {1, 0}, {4, 0}, {4, 4}, {-4, 4}};
  const auto at_bottom = [](const RegionBoundary& boundary) {
    std::size_t count = 0;
    for (const EncroachedSide& e : encroached(boundary))
      count += boundary.points[boundary.sides[e.side][0]] == Point{-1, 0} ? 1 : 0;
    return count;
  };
  EXPECT_EQ(at_bottom(testing::boundary_of({box}, {{0, 0.5}})), 1U);
  const testing::Loop slit{{-3, 0.25}, {3, 0.25}};
  EXPECT_EQ(at_bottom(testing::boundary_of({box, slit}, {{0, 0.5}})), 0U);
}

}  // namespace
}  // namespace cover
