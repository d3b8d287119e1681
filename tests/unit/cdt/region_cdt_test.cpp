#include "cdt/region_cdt.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/faults/internal_fault.hpp"
#include "support/shapes.hpp"

namespace cover {
namespace {

std::optional<BoundaryFault> fault_of(const RegionBoundary& boundary) {
  return find_fault(triangulate_domain(boundary.points, boundary.sides), boundary.points,
                    boundary.sides);
}

const testing::Loop kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(RegionCdt, RegionsWithHolesSlitsAndPointsAreWhole) {
  EXPECT_FALSE(fault_of(testing::boundary_of({kSquare})));
  EXPECT_FALSE(fault_of(testing::boundary_of(
      {kSquare, testing::reversed({{1, 1}, {2, 1}, {2, 2}, {1, 2}}), {{3, 1}, {3, 2}}}, {{1, 3}})));
}

TEST(RegionCdt, NamesWhatRoundingBrokeAndWhere) {
  const auto crossing = fault_of(testing::boundary_of({{{0, 0}, {4, 0}, {1, 3}, {3, 3}}}));
  ASSERT_TRUE(crossing);
  EXPECT_NE(crossing->what.find("cross"), std::string::npos);
  EXPECT_EQ(crossing->where.size(), 4U);
  EXPECT_EQ(crossing->points.size(), 4U);

  const auto lost = fault_of(testing::boundary_of({kSquare}, {{5, 1}}));
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->where, std::vector<Point>({{5, 1}}));

  const auto on_side = fault_of(testing::boundary_of({kSquare}, {{2, 0}}));
  ASSERT_TRUE(on_side);
  EXPECT_EQ(on_side->where.front(), (Point{2, 0}));

  // The left of the outer sides is outside.
  const auto inside_out = fault_of(testing::boundary_of({testing::reversed(kSquare)}));
  ASSERT_TRUE(inside_out);
  EXPECT_NE(inside_out->what.find("left"), std::string::npos);

  // A side with the region on both sides that is given once only.
  RegionBoundary once = testing::boundary_of({kSquare}, {{2, 2}});
  for (std::uint32_t v = 0; v < once.points.size(); ++v) {
    if (once.points[v] != Point{2, 2}) continue;
    for (std::uint32_t u = 0; u < once.points.size(); ++u) {
      if (once.points[u] == Point{0, 0}) once.sides.push_back({u, v});
    }
  }
  std::sort(once.sides.begin(), once.sides.end());
  const auto right = fault_of(once);
  ASSERT_TRUE(right);
  EXPECT_NE(right->what.find("right"), std::string::npos);
}

TEST(RegionCdt, ThrowsAFaultWithThePlace) {
  const RegionBoundary boundary = testing::boundary_of({kSquare}, {{5, 1}});
  try {
    triangulate_region(boundary.points, boundary.sides);
    FAIL() << "no fault";
  } catch (const InternalFault& fault) {
    EXPECT_EQ(fault.where(), std::vector<Point>({{5, 1}}));
  }
}

}  // namespace
}  // namespace cover
