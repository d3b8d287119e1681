#include "cdt/divide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "base/run_all.hpp"
#include "geom/predicates.hpp"

namespace cover {
namespace {

std::vector<Point> random_points(std::size_t n, unsigned seed, double grid) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Point> points;
  for (std::size_t k = 0; k < n; ++k) points.push_back({place(random), place(random)});
  if (grid > 0) {
    for (Point& p : points) p = {std::floor(p.x * grid), std::floor(p.y * grid)};
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::shuffle(points.begin(), points.end(), random);
  }
  return points;
}

bool cross(const std::vector<Point>& p, IndexPair s, IndexPair t) {
  const auto side = [&](IndexPair a, std::uint32_t c) {
    return static_cast<int>(orientation(p[a[0]], p[a[1]], p[c]));
  };
  return side(s, t[0]) * side(s, t[1]) < 0 && side(t, s[0]) * side(t, s[1]) < 0;
}

/// Segments that meet at points only.
std::vector<IndexPair> random_segments(const std::vector<Point>& points, std::size_t tries,
                                       unsigned seed) {
  std::mt19937 random(seed);
  std::vector<IndexPair> found;
  for (std::size_t k = 0; k < tries; ++k) {
    const IndexPair s{static_cast<std::uint32_t>(random() % points.size()),
                      static_cast<std::uint32_t>(random() % points.size())};
    if (s[0] == s[1]) continue;
    const auto is_on = [&](Point p) {
      const Point a = std::min(points[s[0]], points[s[1]]),
                  b = std::max(points[s[0]], points[s[1]]);
      return a < p && p < b && orientation(a, b, p) == Sign::zero;
    };
    if (std::any_of(points.begin(), points.end(), is_on) ||
        std::any_of(found.begin(), found.end(), [&](IndexPair t) { return cross(points, s, t); }))
      continue;
    found.push_back(s);
  }
  return found;
}

using Edges = std::set<std::array<std::uint32_t, 3>>;  // and whether it is locked

Edges edges_of(const Triangulation& t) {
  Edges edges;
  for (const Triangle& f : t.triangles) {
    for (const Corner i : kCorners) {
      const auto [a, b] = std::minmax(f.v[i.next()], f.v[i.previous()]);
      edges.insert({a, b, f.is_locked(i) ? 1U : 0U});
    }
  }
  return edges;
}

/// Counter-clockwise, neighbours mutual, no corner opposite inside a circle but across segments;
/// and as many as fill the hull.
void expect_delaunay(const Triangulation& t) {
  std::size_t outer = 0;
  for (std::uint32_t k = 0; k < t.triangles.size(); ++k) {
    const Triangle& f = t.triangles[k];
    const auto at = [&](std::size_t i) { return t.points[f.v[i]]; };
    ASSERT_EQ(orientation(at(0), at(1), at(2)), Sign::positive);
    for (const Corner i : kCorners) {
      const std::uint32_t n = f.n[i];
      outer += n == kNone ? 1 : 0;
      if (n == kNone) continue;
      const Triangle& g = t.triangles[n];
      const Corner j = g.edge_to(k);
      ASSERT_EQ(g.n[j], k);
      ASSERT_EQ(g.v[j.next()], f.v[i.previous()]);
      ASSERT_EQ(g.is_locked(j), f.is_locked(i));
      if (!f.is_locked(i)) {
        ASSERT_NE(in_circle(at(0), at(1), at(2), t.points[g.v[j]]), Sign::positive);
      }
    }
  }
  EXPECT_EQ(t.triangles.size(), 2 * t.points.size() - 2 - outer);
}

TEST(TriangulateDivided, MakesWhatCgalMakes) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto points = random_points(3 + 13 * seed, seed, 0);
    const auto segments = random_segments(points, seed % 4 * 30, seed);
    const auto divided = triangulate_divided(points, segments, {});
    ASSERT_TRUE(divided) << seed;
    expect_delaunay(*divided);
    EXPECT_EQ(edges_of(*divided), edges_of(triangulate_hull(points, segments).triangulation));
  }
}

TEST(TriangulateDivided, BearsPointsOnLinesAndCircles) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto points = random_points(20 + 20 * seed, seed, 4 + seed % 25);
    const auto segments = random_segments(points, 60, seed);
    const auto divided = triangulate_divided(points, segments, {});
    ASSERT_TRUE(divided) << seed;
    expect_delaunay(*divided);
    std::size_t locked = 0;
    for (const auto& edge : edges_of(*divided)) locked += edge[2];
    std::set<std::pair<std::uint32_t, std::uint32_t>> different;
    for (const IndexPair& s : segments) different.insert(std::minmax(s[0], s[1]));
    EXPECT_EQ(locked, different.size()) << seed;
  }
}

TEST(TriangulateDivided, SaysNothingOfConflicts) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {2, 3}};
  const std::vector<IndexPair> none, through{{0, 2}}, crossing{{1, 5}, {3, 5}, {0, 5}, {2, 3}},
      ring{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  EXPECT_TRUE(triangulate_divided(square, ring, {}));
  EXPECT_FALSE(triangulate_divided(square, through, {}));
  EXPECT_FALSE(triangulate_divided(square, crossing, {}));
  std::vector<Point> line;
  for (int k = 0; k < 100; ++k) line.push_back({k * 0.5, k * 1.5});
  EXPECT_FALSE(triangulate_divided(line, none, {}));
  line.push_back({0, 1});
  EXPECT_TRUE(triangulate_divided(line, none, {}));
  for (unsigned seed = 0; seed < 20; ++seed) {
    auto points = random_points(200, seed, 0);
    points.push_back(points[seed]);
    EXPECT_FALSE(triangulate_divided(points, none, {}));
  }
}

/// Points that several threads put in halves: scattered, on lines, nearly all at one place.
TEST(TriangulateDivided, IsTheSameForAnyNumberOfThreads) {
  constexpr std::size_t kMany = 150'000;
  std::vector<Point> dense = random_points(kMany, 5, 0);
  for (Point& p : dense) p = {std::pow(p.x, 40), p.y * 0.5};
  dense.push_back({3, 2});
  for (const auto& points : {random_points(kMany, 1, 0), random_points(2 * kMany, 2, 450), dense}) {
    const auto segments = random_segments(points, 30, 3);
    const auto alone = triangulate_divided(points, segments, {});
    ASSERT_TRUE(alone);
    for (const unsigned workers : {2U, 3U, 7U}) {
      with_team(workers, [&](const Team& team) {
        const auto divided = triangulate_divided(points, segments, team);
        ASSERT_TRUE(divided);
        ASSERT_EQ(divided->triangles.size(), alone->triangles.size());
        for (std::size_t t = 0; t < alone->triangles.size(); ++t) {
          ASSERT_EQ(divided->triangles[t].v, alone->triangles[t].v);
          ASSERT_EQ(divided->triangles[t].n, alone->triangles[t].n);
        }
      });
    }
  }
}

TEST(TriangulateDivided, StandsAWheel) {
  std::vector<Point> points{{0, 0}};
  std::vector<IndexPair> spokes;
  const std::uint32_t n = 3000;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double turn = 2 * 3.14159265358979 * k / n, radius = 1 + 0.3 * (k % 7);
    points.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    spokes.push_back({0, k + 1});
  }
  const auto divided = triangulate_divided(points, spokes, {});
  ASSERT_TRUE(divided);
  expect_delaunay(*divided);
}

}  // namespace
}  // namespace cover
