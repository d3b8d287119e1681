#include "cdt/region_cdt.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/faults/internal_fault.hpp"
#include "base/run_all.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

std::optional<Flaw> flaw_of(const RegionBoundary& boundary) {
  return find_flaw(triangulate_domain(boundary.points, boundary.sides), boundary.points,
                   boundary.sides);
}

const testing::Loop kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(RegionCdt, RegionsWithHolesSlitsAndPointsAreWhole) {
  EXPECT_FALSE(flaw_of(testing::boundary_of({kSquare})));
  EXPECT_FALSE(flaw_of(testing::boundary_of(
      {kSquare, testing::reversed({{1, 1}, {2, 1}, {2, 2}, {1, 2}}), {{3, 1}, {3, 2}}}, {{1, 3}})));
}

TEST(RegionCdt, NamesWhatRoundingBrokeAndWhere) {
  const auto crossing = flaw_of(testing::boundary_of({{{0, 0}, {4, 0}, {1, 3}, {3, 3}}}));
  ASSERT_TRUE(crossing);
  EXPECT_NE(crossing->what.find("cross"), std::string::npos);
  EXPECT_EQ(crossing->where.size(), 4U);
  EXPECT_EQ(crossing->points.size(), 4U);

  const auto lost = flaw_of(testing::boundary_of({kSquare}, {{5, 1}}));
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->where, std::vector<Point>({{5, 1}}));

  const auto on_side = flaw_of(testing::boundary_of({kSquare}, {{2, 0}}));
  ASSERT_TRUE(on_side);
  EXPECT_EQ(on_side->where.front(), (Point{2, 0}));

  // The left of the outer sides is outside.
  const auto inside_out = flaw_of(testing::boundary_of({testing::reversed(kSquare)}));
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
  const auto right = flaw_of(once);
  ASSERT_TRUE(right);
  EXPECT_NE(right->what.find("right"), std::string::npos);
}

TEST(RegionCdt, ThrowsAFaultWithThePlace) {
  const RegionBoundary boundary = testing::boundary_of({kSquare}, {{5, 1}});
  try {
    triangulate_in_order(boundary.points, boundary.sides);
    FAIL() << "no fault";
  } catch (const InternalFault& fault) {
    EXPECT_EQ(fault.where(), std::vector<Point>({{5, 1}}));
  }
}

using Triples = std::vector<IndexTriple>;

Triples triples_of(const Triangulation& triangulation) {
  Triples triples;
  for (const Triangle& t : triangulation.triangles) triples.push_back(t.v);
  return triples;
}

/// No four of its points are on a circle; a hole, a slit and a point inside.
RegionBoundary odd_region() {
  return testing::boundary_of({{{0, 0}, {4.1, 0.3}, {5.3, 4.7}, {2.2, 6.1}, {-0.7, 3.9}},
                               testing::reversed({{1, 1}, {2.1, 1.2}, {1.7, 2.3}}),
                               {{3.1, 2.2}, {3.7, 3.3}}},
                              {{1.3, 4.1}});
}

TEST(TriangulateRegion, TakesWhatIsKnownIfThereIsNothingElse) {
  const RegionBoundary region = odd_region();
  const Triangulation own = triangulate_in_order(region.points, region.sides);
  Triples known = triples_of(own);
  put_in_order(region.points.size(), known);
  EXPECT_EQ(triples_of(own), known);
  const Triangulation same = triangulate_in_order(region.points, region.sides, known);
  for (std::size_t t = 0; t < own.triangles.size(); ++t) {
    EXPECT_EQ(same.triangles[t].v, own.triangles[t].v);
    EXPECT_EQ(same.triangles[t].n, own.triangles[t].n);
    EXPECT_EQ(same.triangles[t].locked, own.triangles[t].locked);
  }
  std::reverse(known.begin(), known.end());  // so that we can tell
  const Triangulation taken = triangulate_in_order(region.points, region.sides, known);
  EXPECT_EQ(triples_of(taken), known);
  std::size_t locked = 0;
  for (std::uint32_t t = 0; t < taken.triangles.size(); ++t) {
    const Triangle& f = taken.triangles[t];
    for (const Corner i : kCorners) {
      const std::uint32_t n = f.n[i];
      locked += f.is_locked(i) ? 1 : 0;
      if (n == kNone) continue;
      const Triangle& g = taken.triangles[n];
      EXPECT_EQ(g.n[g.edge_to(t)], t);
      EXPECT_EQ(g.is_locked(g.edge_to(t)), f.is_locked(i));
    }
  }
  EXPECT_EQ(locked, region.sides.size());
}

/// More triangles than one thread takes for itself, in any order and from any corner on.
TEST(PutInOrder, IsTheSameForAnyNumberOfThreads) {
  constexpr std::uint32_t kPoints = 40'000;
  Triples triangles;
  for (std::uint32_t k = 0; k < 2 * kPoints; ++k) {
    const std::uint32_t v = 7919 * k % kPoints;
    triangles.push_back({(v + 3 + k % 5) % kPoints, v, (v + 1 + k % 2) % kPoints});
  }
  Triples alone = triangles;
  put_in_order(kPoints, alone);
  EXPECT_TRUE(std::is_sorted(alone.begin(), alone.end()));
  for (const unsigned workers : {2U, 3U, 7U}) {
    with_team(workers, [&](const Team& team) {
      Triples sorted = triangles;
      put_in_order(kPoints, sorted, team);
      EXPECT_EQ(sorted, alone);
    });
  }
}

TEST(TriangulateRegion, FindsItselfWhatIsKnownWrongly) {
  const RegionBoundary region = odd_region();
  const Triples right = triples_of(triangulate_in_order(region.points, region.sides));
  const auto expect_own = [&](Triples known, const char* what) {
    std::reverse(known.begin(), known.end());
    EXPECT_EQ(triples_of(triangulate_in_order(region.points, region.sides, known)), right) << what;
  };
  Triples wrong = right;
  wrong.pop_back();
  expect_own(wrong, "a triangle is missing");
  wrong = right;
  wrong[0][1] = static_cast<std::uint32_t>(region.points.size());
  expect_own(wrong, "no such point");
  wrong = right;
  std::swap(wrong[0][1], wrong[0][2]);
  expect_own(wrong, "clockwise");
  // The other diagonal of any two triangles that makes triangles, too.
  const Triangulation own = triangulate_in_order(region.points, region.sides);
  std::size_t flipped = 0;
  for (std::uint32_t t = 0; t < own.triangles.size(); ++t) {
    for (const Corner i : kCorners) {
      const Triangle& f = own.triangles[t];
      if (f.is_locked(i) || f.n[i] < t) continue;
      const Triangle& g = own.triangles[f.n[i]];
      const std::uint32_t d = g.v[g.edge_to(t)];
      wrong = right;
      wrong[t] = {f.v[i], f.v[i.next()], d};
      wrong[f.n[i]] = {f.v[i], d, f.v[i.previous()]};
      expect_own(wrong, "not Delaunay");
      ++flipped;
    }
  }
  EXPECT_GT(flipped, 5U);
}

TEST(TriangulateRegion, FindsItselfWhatMayBeOtherwise) {
  const RegionBoundary square = testing::boundary_of({kSquare});
  const Triples own = triples_of(triangulate_in_order(square.points, square.sides));
  ASSERT_EQ(own.size(), 2U);
  for (std::uint32_t first = 0; first < 2; ++first) {  // with either diagonal
    Triples known{{0, 1, 2}, {0, 2, 3}};
    std::vector<std::uint32_t> around{0};  // the corners counter-clockwise
    while (around.size() < 4) {
      for (const IndexPair& side : square.sides)
        if (side[0] == around.back() && around.size() < 4) around.push_back(side[1]);
    }
    for (IndexTriple& t : known)
      for (std::uint32_t& v : t) v = around[(v + first) % 4];
    EXPECT_EQ(triples_of(triangulate_in_order(square.points, square.sides, known)), own);
  }
}

}  // namespace
}  // namespace cover
