#include "cdt/search/locate.hpp"

#include <gtest/gtest.h>

#include "cdt/cdt.hpp"
#include "geom/predicates.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

TEST(Locator, TellsInsideEdgeVertexAndOutside) {
  const std::vector<Point> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const std::vector<IndexPair> diagonal{{0, 2}};
  const Triangulation t = triangulate_hull(square, diagonal).triangulation;
  Locator locator(t);
  EXPECT_EQ(locator.locate({3, 1}).kind, Location::Kind::inside);
  const Location edge = locator.locate({1, 1});
  EXPECT_EQ(edge.kind, Location::Kind::on_edge);
  EXPECT_TRUE(t.triangles[edge.triangle].is_locked(edge.index));
  const Location corner = locator.locate({0, 4});
  EXPECT_EQ(corner.kind, Location::Kind::on_vertex);
  EXPECT_EQ(t.triangles[corner.triangle].v[static_cast<std::size_t>(corner.index)], 3U);
  EXPECT_EQ(locator.locate({5, 1}).kind, Location::Kind::outside);
  EXPECT_EQ(locator.locate({4, 1}).kind, Location::Kind::on_edge);
}

TEST(Locator, EndsInTriangulationsThatAreNotDelaunay) {
  const std::uint64_t seed = testing::test_seed(4);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  const auto boundary = testing::boundary_of({testing::random_star(2000, 0.05, random)});
  const Triangulation t = triangulate_hull(boundary.points, boundary.sides).triangulation;
  Locator locator(t);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int k = 0; k < 2000; ++k) {
    const Point p{uniform(random), uniform(random)};
    const Location at = locator.locate(p);
    if (at.kind == Location::Kind::outside) continue;
    const auto& v = t.triangles[at.triangle].v;
    for (const Corner i : kCorners) {
      ASSERT_NE(orientation(t.points[v[i]], t.points[v[i.next()]], p), Sign::negative);
    }
  }
}

}  // namespace
}  // namespace cover
