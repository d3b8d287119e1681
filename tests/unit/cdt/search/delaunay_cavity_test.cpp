#include "cdt/search/delaunay_cavity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "cdt/cdt.hpp"

namespace cover {
namespace {

/// Triangles, and edges of theirs.
using Rim = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Points of a grid, many of them on common circles, or about one circle; with a few segments.
Triangulation random_triangulation(std::mt19937& random, bool is_ring) {
  std::set<Point> points;
  while (points.size() < 60) {
    const auto x = static_cast<double>(random() % 16), y = static_cast<double>(random() % 16);
    const double angle = 0.02 * (16 * x + y);
    points.insert(is_ring ? Point{8 + 7 * std::cos(angle), 8 + 7 * std::sin(angle)} : Point{x, y});
  }
  const std::vector<Point> list(points.begin(), points.end());
  std::vector<IndexPair> segments;
  for (int tries = 0; tries < 12; ++tries) {
    const auto a = static_cast<std::uint32_t>(random() % list.size());
    const auto b = static_cast<std::uint32_t>(random() % list.size());
    if (a == b) continue;
    segments.push_back({a, b});
    if (!triangulate_hull(list, segments).conflicts.empty()) segments.pop_back();
  }
  return triangulate_hull(list, segments).triangulation;
}

bool has_in_circle(const Triangulation& cdt, std::uint32_t t, Point p) {
  const auto& [a, b, c] = cdt.triangles[t].v;
  return in_circle(cdt.points[a], cdt.points[b], cdt.points[c], p) == Sign::positive;
}

/// Triangle after triangle, until no neighbour is missing.
std::set<std::uint32_t> expected_cavity(const Triangulation& cdt, std::uint32_t start, Point p) {
  std::set<std::uint32_t> cavity{start};
  for (std::size_t before = 0; before != cavity.size();) {
    before = cavity.size();
    for (std::uint32_t t = 0; t < cdt.triangles.size(); ++t) {
      for (const Corner i : kCorners) {
        const std::uint32_t n = cdt.triangles[t].n[i];
        if (n != kNone && !cdt.triangles[t].is_locked(i) && cavity.contains(n) &&
            has_in_circle(cdt, t, p))
          cavity.insert(t);
      }
    }
  }
  return cavity;
}

Rim expected_rim(const Triangulation& cdt, const std::set<std::uint32_t>& cavity) {
  Rim rim;
  for (const std::uint32_t t : cavity) {
    const Triangle& f = cdt.triangles[t];
    for (const Corner i : kCorners) {
      if (f.n[i] == kNone || f.is_locked(i) || !cavity.contains(f.n[i])) rim.emplace(t, i);
    }
  }
  return rim;
}

std::uint32_t triangle_with(const Triangulation& cdt, Point p) {
  for (std::uint32_t t = 0; t < cdt.triangles.size(); ++t) {
    const auto& v = cdt.triangles[t].v;
    if (orientation(cdt.points[v[0]], cdt.points[v[1]], p) == Sign::positive &&
        orientation(cdt.points[v[1]], cdt.points[v[2]], p) == Sign::positive &&
        orientation(cdt.points[v[2]], cdt.points[v[0]], p) == Sign::positive)
      return t;
  }
  return kNone;
}

const auto kGoesOn = [](std::uint32_t, Corner) { return true; };

TEST(DelaunayCavity, HasTheTrianglesAndTheRimOfBruteForce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 15);
  DelaunayCavity cavity;
  std::size_t tried = 0, largest = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Triangulation cdt = random_triangulation(random, trial % 4 == 0);
    for (int k = 0; k < 40; ++k) {
      const Point p{place(random), place(random)};
      const std::uint32_t start = triangle_with(cdt, p);
      if (start == kNone) continue;
      cavity.begin(cdt.triangles.size(), start);
      Rim rim;
      std::size_t told = 0;
      EXPECT_TRUE(cavity.grow(p, cdt, [&](std::uint32_t t, Corner i) {
        rim.emplace(t, i);
        ++told;
        return true;
      }));
      const std::set<std::uint32_t> expected = expected_cavity(cdt, start, p);
      ASSERT_EQ(std::set(cavity.triangles().begin(), cavity.triangles().end()), expected);
      ASSERT_EQ(cavity.size(), expected.size());
      ASSERT_EQ(rim, expected_rim(cdt, expected));
      ASSERT_EQ(told, rim.size());
      // A disk without a vertex inside, all of whose rim the point sees.
      ASSERT_EQ(rim.size(), cavity.size() + 2);
      for (const auto& [t, i] : rim) {
        const Corner c = i;
        const auto& v = cdt.triangles[t].v;
        ASSERT_EQ(orientation(cdt.points[v[c.next()]], cdt.points[v[c.previous()]], p),
                  Sign::positive);
      }
      ++tried;
      largest = std::max(largest, cavity.size());
    }
  }
  EXPECT_GT(tried, 1000U);
  EXPECT_GT(largest, 20U);
}

TEST(DelaunayCavity, EndsWhereItIsToldTo) {
  std::mt19937 random(11);
  const Triangulation cdt = random_triangulation(random, false);
  const Point p{7.3, 7.6};
  const std::uint32_t start = triangle_with(cdt, p);
  ASSERT_NE(start, kNone);
  const std::size_t whole = expected_cavity(cdt, start, p).size();
  ASSERT_GT(whole, 2U);
  DelaunayCavity cavity;
  const auto begin = [&] { cavity.begin(cdt.triangles.size(), start); };
  int told = 0;
  begin();
  EXPECT_FALSE(cavity.grow(p, cdt, [&](std::uint32_t, Corner) { return ++told < 3; }));
  EXPECT_EQ(told, 3);
  const auto across = [&](std::uint32_t t, Corner i) { return cdt.triangles[t].n[i]; };
  const auto corners = [&](std::uint32_t t) {
    const auto& [a, b, c] = cdt.triangles[t].v;
    return std::array{cdt.points[a], cdt.points[b], cdt.points[c]};
  };
  begin();
  EXPECT_TRUE(cavity.grow(p, across, corners, kGoesOn, whole + 100));
  const std::size_t without_walls = cavity.size();
  EXPECT_GE(without_walls, whole);
  begin();
  EXPECT_TRUE(cavity.grow(p, across, corners, kGoesOn, without_walls));
  begin();
  EXPECT_FALSE(cavity.grow(p, across, corners, kGoesOn, without_walls - 1));
  // Nothing passes.
  begin();
  EXPECT_TRUE(cavity.grow(
      p, [](std::uint32_t, Corner) { return kNone; }, corners, kGoesOn));
  EXPECT_EQ(cavity.triangles(), std::vector<std::uint32_t>{start});
}

}  // namespace
}  // namespace cover
