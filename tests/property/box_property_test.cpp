// The theorems of docs/box_method.md against random regions and random meshes of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "box/encroached_sides.hpp"
#include "box/forced_cuts.hpp"
#include "box/least_cuts.hpp"
#include "cdt/cdt.hpp"
#include "cdt/couplings.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "support/inputs/random_regions.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

/// Random meshes: COVER_BOX_TRIALS if set.
std::size_t trials() { return testing::cases_asked_for("COVER_BOX_TRIALS", 4000); }

std::vector<IndexTriple> triangles_of(const Triangulation& cdt) {
  std::vector<IndexTriple> triangles;
  for (const Triangle& t : cdt.triangles) triangles.push_back(t.v);
  return triangles;
}

/// A mesh of the region with up to 12 random vertices, none on its boundary.
struct RandomMesh {
  std::vector<Point> points;
  std::vector<IndexTriple> triangles;
  Triangulation cdt;
};

RandomMesh random_mesh(const RegionBoundary& boundary, const Triangulation& plain,
                       std::mt19937_64& random) {
  RandomMesh mesh;
  mesh.points = boundary.points;
  const std::size_t more = random() % 13;
  std::uniform_real_distribution<double> share(0, 1);
  for (std::size_t k = 0; k < more && !plain.triangles.empty(); ++k) {
    const auto& v = plain.triangles[random() % plain.triangles.size()].v;
    const double r = share(random), s = share(random) * (1 - r);
    const Point a = plain.points[v[0]];
    const Point p = a + (r * (plain.points[v[1]] - a) + s * (plain.points[v[2]] - a));
    const bool is_inside =
        orientation(plain.points[v[0]], plain.points[v[1]], p) == Sign::positive &&
        orientation(plain.points[v[1]], plain.points[v[2]], p) == Sign::positive &&
        orientation(plain.points[v[2]], plain.points[v[0]], p) == Sign::positive;
    if (is_inside && std::find(mesh.points.begin(), mesh.points.end(), p) == mesh.points.end())
      mesh.points.push_back(p);
  }
  mesh.cdt = triangulate_domain(mesh.points, boundary.sides).triangulation;
  mesh.triangles = triangles_of(mesh.cdt);
  return mesh;
}

/// Flips some edges, Delaunay or not, where the two triangles stay counter-clockwise.
void flip_at_random(RandomMesh& mesh, std::mt19937_64& random) {
  std::vector<std::uint8_t> changed(mesh.cdt.triangles.size(), 0);
  for (std::uint32_t t = 0; t < mesh.cdt.triangles.size(); ++t) {
    const Corner i = static_cast<std::uint32_t>(random() % 3);
    const std::uint32_t u = mesh.cdt.triangles[t].n[i];
    if (u == kNone || mesh.cdt.triangles[t].is_locked(i) || changed[t] != 0 || changed[u] != 0)
      continue;
    const auto& v = mesh.cdt.triangles[t].v;
    const std::uint32_t a = v[i], b = v[i.next()], c = v[i.previous()];
    const Triangle& other = mesh.cdt.triangles[u];
    const std::uint32_t d = other.v[other.edge_to(t)];
    if (orientation(mesh.points[a], mesh.points[b], mesh.points[d]) != Sign::positive ||
        orientation(mesh.points[a], mesh.points[d], mesh.points[c]) != Sign::positive)
      continue;
    mesh.triangles[t] = {a, b, d};
    mesh.triangles[u] = {a, d, c};
    changed[t] = changed[u] = 1;
  }
}

TEST(BoxMethod, EncroachedSidesAreNegativeInEveryMeshAndOthersNeedNotBe) {
  const std::uint64_t seed = testing::test_seed(14);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::size_t forced = 0, free = 0;
  for (std::size_t trial = 0; trial < trials();) {
    const RegionBoundary boundary = testing::random_region(random).boundary;
    const Triangulation plain = triangulate_domain(boundary.points, boundary.sides).triangulation;
    const auto encroached = encroached_sides(plain, locate_sides(plain, boundary.sides));
    const auto of_plain = negative_edges(boundary.points, triangles_of(plain), boundary.sides);
    // Without new vertices: just the encroached sides.
    ASSERT_EQ(of_plain.size(), encroached.size());
    for (const NegativeEdge& e : of_plain) {
      ASSERT_TRUE(e.is_side);
      ASSERT_TRUE(std::any_of(encroached.begin(), encroached.end(), [&](const EncroachedSide& s) {
        return boundary.sides[s.side] == e.edge;
      }));
    }
    for (int k = 0; k < 10; ++k, ++trial) {
      RandomMesh mesh = random_mesh(boundary, plain, random);
      const auto negative = negative_edges(mesh.points, mesh.triangles, boundary.sides);
      for (const EncroachedSide& e : encroached) {
        ASSERT_TRUE(std::any_of(negative.begin(), negative.end(), [&](const NegativeEdge& n) {
          return n.is_side && n.edge == boundary.sides[e.side];
        }));
      }
      for (const NegativeEdge& n : negative) ASSERT_TRUE(n.is_side);
      if (encroached.empty()) {
        ++free;
        continue;
      }
      ++forced;
      flip_at_random(mesh, random);
      ASSERT_FALSE(negative_edges(mesh.points, mesh.triangles, boundary.sides).empty());
    }
  }
  EXPECT_GT(forced, trials() / 10);
  EXPECT_GT(free, trials() / 100);
}

/// The boundary with a side, and its other side if it is a slit, cut at points along it.
RegionBoundary cut(RegionBoundary boundary, SegmentId segment, const std::vector<Point>& points) {
  RegionBoundary out = boundary;
  out.sides.clear();
  const auto first = static_cast<std::uint32_t>(out.points.size());
  out.points.insert(out.points.end(), points.begin(), points.end());
  Point start{};
  bool has_start = false;
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
    const auto [a, b] = boundary.sides[s];
    if (boundary.segments[s] != segment) {
      out.sides.push_back({a, b});
      continue;
    }
    if (!has_start) start = std::min(boundary.points[a], boundary.points[b]);
    has_start = true;
    const bool forward = boundary.points[a] == start;
    std::uint32_t from = a;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      const auto at = first + (forward ? k : static_cast<std::uint32_t>(points.size()) - 1 - k);
      out.sides.push_back({from, at});
      from = at;
    }
    out.sides.push_back({from, b});
  }
  std::sort(out.sides.begin(), out.sides.end());
  return out;
}

TEST(BoxMethod, FewerCutsThanTheBoundLeaveAnEncroachedPiece) {
  const std::uint64_t seed = testing::test_seed(15);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::size_t tried = 0;
  for (std::size_t trial = 0; trial < trials() / 4; ++trial) {
    const RegionBoundary boundary = testing::random_region(random).boundary;
    const Triangulation plain = triangulate_domain(boundary.points, boundary.sides).triangulation;
    std::vector<std::vector<EncroachedSegment>> found{encroached_segments(boundary, plain)};
    if (found[0].empty()) continue;
    const EncroachedSegment& e = found[0][random() % found[0].size()];
    if (e.segment == kHullSide) continue;
    const std::size_t least = least_cuts(e.obstacles);
    if (least < 2) continue;
    const Point a = std::min(e.a, e.b), b = std::max(e.a, e.b);
    // Random places, or greedy ones from an end or from somewhere else: the best that is known.
    std::vector<double> places;
    for (int attempt = 0; attempt < 4; ++attempt) {
      places.clear();
      if (attempt == 0) {
        while (places.size() + 1 < least) places.push_back(share(random));
      } else {
        double start = attempt == 1 ? 0 : share(random) / static_cast<double>(least);
        if (attempt > 1) places.push_back(start);
        while (places.size() + 1 < least) {
          start = longest_piece(e.obstacles, start, 0);
          if (start >= 1) break;
          places.push_back(start);
        }
      }
      std::sort(places.begin(), places.end());
      std::vector<Point> points;
      for (const double t : places) points.push_back(a + t * (b - a));
      const RegionBoundary with_cuts = cut(boundary, e.segment, points);
      const CdtResult cdt = triangulate_domain(with_cuts.points, with_cuts.sides);
      if (!cdt.conflicts.empty()) continue;  // rounding moved a cut over something
      ++tried;
      bool is_encroached = false;
      for (const EncroachedSide& s :
           encroached_sides(cdt.triangulation, locate_sides(cdt.triangulation, with_cuts.sides))) {
        const auto [u, v] = with_cuts.sides[s.side];
        const auto on_segment = [&](std::uint32_t w) {
          return w >= boundary.points.size() || with_cuts.points[w] == a ||
                 with_cuts.points[w] == b;
        };
        is_encroached = is_encroached || (on_segment(u) && on_segment(v));
      }
      EXPECT_TRUE(is_encroached) << "with " << points.size() << " cuts, at least " << least;
    }
  }
  EXPECT_GT(tried, trials() / 100);
}

}  // namespace
}  // namespace cover
