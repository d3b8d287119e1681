#include "cdt/couplings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"

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
  EXPECT_EQ(found[0].edge, (IndexPair{2, 0}));
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

TEST(Couplings, FlipsMakeAnyTriangulationDelaunay) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0, 1);
  for (int trial = 0; trial < 50; ++trial) {
    // A fan around a corner of the square, over points that were never asked.
    std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<IndexTriple> triangles{{0, 1, 2}, {0, 2, 3}};
    for (int k = 0; k < 30; ++k) {
      const Point p{place(random), place(random)};
      const auto v = static_cast<std::uint32_t>(points.size());
      points.push_back(p);
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto [a, b, c] = triangles[t];
        if (orientation(points[a], points[b], p) != Sign::positive ||
            orientation(points[b], points[c], p) != Sign::positive ||
            orientation(points[c], points[a], p) != Sign::positive)
          continue;
        triangles[t] = {a, b, v};
        triangles.push_back({b, c, v});
        triangles.push_back({c, a, v});
        break;
      }
    }
    EXPECT_GT(make_delaunay(points, triangles, kSides), 0U);
    EXPECT_EQ(make_delaunay(points, triangles, kSides), 0U);
    for (const NegativeEdge& e : negative_edges(points, triangles, kSides)) EXPECT_TRUE(e.is_side);
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
      EXPECT_EQ(orientation(points[a], points[b], points[c]), Sign::positive);
      area += cross(points[b] - points[a], points[c] - points[a]) / 2;
    }
    EXPECT_NEAR(area, 1, 1e-12);
  }
}

}  // namespace
}  // namespace cover
