#include "geom/topology/half_edges.hpp"

#include <gtest/gtest.h>

#include "base/run_all.hpp"

namespace cover {
namespace {

/// A grid of n x n squares, each cut in two; the triangles in no special order.
std::vector<IndexTriple> grid(std::uint32_t n) {
  std::vector<IndexTriple> triangles;
  const auto at = [n](std::uint32_t x, std::uint32_t y) { return (n + 1) * y + x; };
  for (std::uint32_t k = 0; k < n * n; ++k) {
    const std::uint32_t cell = 7 * k % (n * n), x = cell % n, y = cell / n;
    triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
    triangles.push_back({at(x, y + 1), at(x + 1, y), at(x + 1, y + 1)});
  }
  return triangles;
}

TEST(HalfEdges, OppositeOnesAgreeWithASearch) {
  for (const std::uint32_t n : {1U, 2U, 5U, 8U}) {
    const std::vector<IndexTriple> triangles = grid(n);
    const std::size_t vertices = (n + 1) * (n + 1);
    const HalfEdges edges(vertices, triangles);
    EXPECT_TRUE(edges.all_different());
    const std::vector<std::uint32_t> opposite = opposite_half_edges(vertices, triangles);
    ASSERT_EQ(opposite.size(), edges.size());
    std::size_t outer = 0;
    for (std::uint32_t h = 0; h < edges.size(); ++h) {
      EXPECT_EQ(opposite[h], edges.twin(h));
      if (opposite[h] == kNone) ++outer;
    }
    EXPECT_EQ(outer, 4 * n);
  }
}

// A hub that has the lowest number of all; with 1e5 triangles this takes minutes if it is
// quadratic.
TEST(HalfEdges, OppositeOnesAroundAHub) {
  for (const std::uint32_t spokes : {3U, 30U, 100000U}) {
    std::vector<IndexTriple> wheel;
    for (std::uint32_t k = 0; k < spokes; ++k) wheel.push_back({0, 1 + k, 1 + (k + 1) % spokes});
    const HalfEdges edges(spokes + 1, wheel);
    const std::vector<std::uint32_t> opposite = opposite_half_edges(spokes + 1, wheel);
    ASSERT_EQ(opposite.size(), edges.size());
    for (std::uint32_t h = 0; h < edges.size(); ++h) ASSERT_EQ(opposite[h], edges.twin(h));
  }
}

/// More triangles than one thread takes for itself; vertices in no special order.
TEST(HalfEdges, AreTheSameForAnyNumberOfThreads) {
  constexpr std::uint32_t kSide = 211;
  constexpr std::size_t kVertices = (kSide + 1) * (kSide + 1);
  std::vector<IndexTriple> triangles = grid(kSide);
  for (IndexTriple& t : triangles) {
    for (std::uint32_t& v : t) v = static_cast<std::uint32_t>(v * std::size_t{7919} % kVertices);
  }
  const HalfEdges alone(kVertices, triangles);
  const std::vector<std::uint32_t> opposite = opposite_half_edges(kVertices, triangles);
  std::vector<IndexTriple> doubled = triangles;
  doubled.push_back(triangles[1]);
  for (const unsigned workers : {2U, 3U, 7U}) {
    with_team(workers, [&](const Team& team) {
      EXPECT_EQ(opposite_half_edges(kVertices, triangles, team), opposite);
      const HalfEdges edges(kVertices, triangles, team);
      EXPECT_TRUE(edges.all_different(team));
      EXPECT_FALSE(HalfEdges(kVertices, doubled, team).all_different(team));
      for (std::uint32_t h = 0; h < edges.size(); ++h) {
        ASSERT_EQ(edges.find(edges.source(h), edges.target(h)), h);
        ASSERT_EQ(edges.twin(h), alone.twin(h));
      }
    });
  }
}

/// Lists of half-edges that wait are given up for sorting, by threads, too.
TEST(HalfEdges, AroundAHubByThreads) {
  constexpr std::uint32_t kSpokes = 100'000;
  std::vector<IndexTriple> wheel;
  for (std::uint32_t k = 0; k < kSpokes; ++k) wheel.push_back({0, 1 + k, 1 + (k + 37) % kSpokes});
  const std::vector<std::uint32_t> opposite = opposite_half_edges(kSpokes + 1, wheel);
  with_team(3, [&](const Team& team) {
    EXPECT_EQ(opposite_half_edges(kSpokes + 1, wheel, team), opposite);
  });
}

TEST(HalfEdges, OppositeOnesOfNothing) { EXPECT_TRUE(opposite_half_edges(3, {}).empty()); }

}  // namespace
}  // namespace cover
