#include "cdt/couplings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cover {
namespace {

const std::vector<IndexPair> kSides{{0, 1}, {1, 2}, {2, 3}, {3, 0}};

TEST(Couplings, OnACircleAreNone) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}, {0, 2, 3}};
  EXPECT_TRUE(negative_edges(square, triangles, kSides).empty());
}

TEST(Couplings, AreFoundOneUnitInTheLastPlaceBeyond) {
  // The circle through 0, 1 and 2 passes through (0, 1).
  std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {std::nextafter(0.0, 1.0), 1}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}, {0, 2, 3}};
  std::vector<NegativeEdge> found = negative_edges(points, triangles, kSides);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].is_side);
  EXPECT_EQ(found[0].edge, (IndexPair{0, 2}));
  points[3] = {-std::nextafter(0.0, 1.0), 1};
  EXPECT_TRUE(negative_edges(points, triangles, kSides).empty());
}

TEST(Couplings, OfSidesCountTheOneAngleThereIs) {
  const std::vector<Point> flat{{-1, 0}, {1, 0}, {0, 0.5}};
  const std::vector<IndexTriple> triangle{{0, 1, 2}};
  const std::vector<IndexPair> sides{{0, 1}, {1, 2}, {2, 0}};
  const std::vector<NegativeEdge> found = negative_edges(flat, triangle, sides);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].is_side);
  EXPECT_EQ(found[0].apex, 2U);
}

TEST(Couplings, ASlitHasTwoSides) {
  // A flat quadrilateral: as an inner edge 0-2 is Delaunay, as a slit it is seen at 120 degrees
  // from one side.
  const std::vector<Point> points{{-1, 0}, {0, -0.5}, {1, 0}, {0, 8}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}, {0, 2, 3}};
  EXPECT_TRUE(negative_edges(points, triangles, kSides).empty());
  const std::vector<IndexPair> with_slit{{0, 1}, {0, 2}, {1, 2}, {2, 0}, {2, 3}, {3, 0}};
  const std::vector<NegativeEdge> found = negative_edges(points, triangles, with_slit);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].is_side);
}

}  // namespace
}  // namespace cover
