#include "limits/couplings/half_disc_room.hpp"

#include "limits/couplings/forced_sides.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "box/encroached_sides.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "support/inputs/random_regions.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using namespace testing;
using Corners = std::array<Point, 3>;

struct Region {
  explicit Region(RegionBoundary its) : boundary(std::move(its)) {
    cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
    is_free.assign(boundary.sides.size(), true);
    for (const EncroachedSide& e : encroached_sides(cdt, locate_sides(cdt, boundary.sides)))
      is_free[e.side] = false;
  }
  [[nodiscard]] HalfDiscRoom room() const { return {boundary.points, boundary.sides, is_free}; }
  [[nodiscard]] Corners corners(const Triangle& t) const {
    return {boundary.points[t.v[0]], boundary.points[t.v[1]], boundary.points[t.v[2]]};
  }

  RegionBoundary boundary;
  Triangulation cdt;
  std::vector<bool> is_free;
};

bool crosses(Point a, Point b, Point c, Point d) {
  return orientation(a, b, c) != orientation(a, b, d) &&
         orientation(c, d, a) != orientation(c, d, b);
}

/// Whether the coupling of a free side becomes negative with a vertex at `p`: it sees a place
/// inside the side, by looking at some.
bool is_in_a_half_disc(const Region& region, Point p) {
  const auto& [points, sides] = std::tie(region.boundary.points, region.boundary.sides);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const Point a = points[sides[s][0]], b = points[sides[s][1]];
    if (!region.is_free[s] || orientation(a, b, p) != Sign::positive ||
        compare_with_90_degrees(a, p, b) != Sign::positive)
      continue;
    for (const double share : {0.5, 0.1, 0.9, 0.3, 0.7, 0.01, 0.99, 0.001, 0.999}) {
      const Point q = a + share * (b - a);
      bool sees = true;
      for (std::size_t w = 0; w < sides.size() && sees; ++w)
        sees = w == s || (sides[w][0] == sides[s][1] && sides[w][1] == sides[s][0]) ||
               !crosses(p, q, points[sides[w][0]], points[sides[w][1]]);
      if (sees) return true;
    }
  }
  return false;
}

/// Half a disc around its diameter, with so many chords.
Loop half_disc(int chords, double radius) {
  Loop loop{{1, 0}};
  for (int k = 1; k < chords; ++k) {
    const double t = std::numbers::pi * k / chords;
    loop.push_back({radius * std::cos(t), radius * std::sin(t)});
  }
  loop.push_back({-1, 0});
  return loop;
}

TEST(HalfDiscRoom, ADiameterIsForcedAndNothingElse) {
  for (const int chords : {7, 12, 24}) {
    const Region region(boundary_of({half_disc(chords, 1.0001)}));
    std::vector<Corners> ears;
    for (const Triangle& t : region.cdt.triangles) {
      const Corners c = region.corners(t);
      for (std::size_t i = 0; i < 3; ++i) {
        if (angle_at(c[i], c[(i + 1) % 3], c[(i + 2) % 3]) > 150 * std::numbers::pi / 180)
          ears.push_back(c);
      }
    }
    ASSERT_FALSE(ears.empty());
    std::vector<std::uint32_t> all(region.boundary.sides.size());
    std::uint32_t diameter = 0;
    for (std::uint32_t s = 0; s < all.size(); ++s) {
      all[s] = s;
      const auto& [a, b] = region.boundary.sides[s];
      if (length(region.boundary.points[b] - region.boundary.points[a]) == 2) diameter = s;
    }
    const auto forced = [&](std::vector<std::uint32_t> negative) {
      return forced_sides(region.boundary.points, region.boundary.sides, region.is_free, ears,
                          negative);
    };
    EXPECT_EQ(forced({diameter}), std::vector<std::uint32_t>{diameter}) << chords;
    EXPECT_TRUE(forced({}).empty());
    EXPECT_EQ(forced(all).size(), 1u);  // whichever: one is enough
  }
}

TEST(HalfDiscRoom, ThereIsSomeAroundTheMiddleOfAPolygonWithEqualSides) {
  Loop loop;
  for (int k = 0; k < 9; ++k)
    loop.push_back(
        {std::cos(2 * std::numbers::pi * k / 9), std::sin(2 * std::numbers::pi * k / 9)});
  const Region region(boundary_of({loop}));
  const HalfDiscRoom::Room room = region.room().within_circle({loop[0], loop[3], loop[6]}, 20);
  EXPECT_FALSE(room.is_none);
  EXPECT_GE(room.places.size(), 20u);
  for (const Point& p : room.places) EXPECT_FALSE(is_in_a_half_disc(region, p));
}

/// Points on an ellipse; one of them moved inwards, every other time.
RegionBoundary small_region(std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const double stretch = 1 + 3 * share(random);
  std::vector<double> turns(4 + random() % 5);
  for (double& t : turns) t = 2 * std::numbers::pi * share(random);
  std::sort(turns.begin(), turns.end());
  Loop loop;
  for (const double t : turns) loop.push_back({stretch * std::cos(t), std::sin(t)});
  if (random() % 2 == 0) {
    const std::size_t n = loop.size(), k = random() % n;
    const Point m = midpoint(loop[(k + 1) % n], loop[(k + n - 1) % n]);
    loop[k] = m + 0.9 * share(random) * (loop[k] - m);
  }
  return boundary_of({loop});
}

/// Whatever it says is so, by a look at single points: in small regions, and in those of every
/// awkward kind.
TEST(HalfDiscRoom, IsNoneOnlyWhereEveryPointIsInAHalfDisc) {
  std::mt19937_64 random(11);
  std::size_t none = 0, some = 0, looked_at = 0;
  for (int k = 0; k < 920; ++k) {
    const Region region(k < 900 ? small_region(random) : random_region(random).boundary);
    if (region.boundary.points.size() > 60) continue;
    const HalfDiscRoom room = region.room();
    for (std::size_t t = 0; t < region.cdt.triangles.size(); t += 3) {
      const Corners c = region.corners(region.cdt.triangles[t]);
      const HalfDiscRoom::Room found = room.within_circle(c, 8);
      (found.is_none ? none : some) += 1;
      for (const Point& p : found.places) {
        EXPECT_EQ(in_circle(c[0], c[1], c[2], p), Sign::positive);
        EXPECT_FALSE(is_in_a_half_disc(region, p)) << k;
      }
      if (!found.is_none) continue;
      EXPECT_TRUE(found.places.empty());
      std::uniform_real_distribution<double> share(0, 1);
      for (const Triangle& other : region.cdt.triangles) {
        const Corners o = region.corners(other);
        const double u = share(random), v = share(random) * (1 - u);
        const Point p = o[0] + u * (o[1] - o[0]) + v * (o[2] - o[0]);
        const bool is_inside = orientation(o[0], o[1], p) == Sign::positive &&
                               orientation(o[1], o[2], p) == Sign::positive &&
                               orientation(o[2], o[0], p) == Sign::positive;
        if (!is_inside || in_circle(c[0], c[1], c[2], p) != Sign::positive) continue;
        ++looked_at;
        EXPECT_TRUE(is_in_a_half_disc(region, p)) << k << ' ' << p.x << ' ' << p.y;
      }
    }
  }
  EXPECT_GT(none, 40u);
  EXPECT_GT(some, 100u);
  EXPECT_GT(looked_at, 60u);
}

}  // namespace
}  // namespace cover
