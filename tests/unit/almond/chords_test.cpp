#include "almond/chords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "almond/almond_triangles.hpp"
#include "almond/arc_walk.hpp"
#include "almond/fill/remainder.hpp"
#include "support/shapes.hpp"

namespace cover {
namespace {

constexpr double kPi = std::numbers::pi;

/// All stages up to the chords of one region.
struct Stages {
  RegionBoundary boundary;
  Triangulation cdt;
  AngleLimit limit;
  std::vector<Almond> almonds;
  CutRule rule;
  ChordLayer layer;

  explicit Stages(RegionBoundary region, bool paper = true) : boundary(std::move(region)) {
    cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
    limit = angle_limit(cdt, boundary.sides, boundary.segments);
    almonds = make_almonds(cdt, boundary.sides, boundary.segments, limit, {});
    rule = {paper, 6, limit.promised_nu(), 1e-15};
    layer = cut_chords(lay_arcs(cdt, almonds, 1), almonds, rule);
  }
  [[nodiscard]] std::size_t count(ChordKind kind) const {
    return static_cast<std::size_t>(std::count_if(layer.chords.begin(), layer.chords.end(),
                                                  [&](const auto& c) { return c.kind == kind; }));
  }
};

RegionBoundary square() { return testing::boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}); }

TEST(WalkAlmonds, KnowsTheApexByIdentityAndCocircularVertices) {
  // Seen from the long lower side, the three upper vertices lie on one circle (3-4-5 and the top).
  const Stages s(testing::boundary_of({{{-5, 0}, {5, 0}, {4, 3}, {0, 5}, {-4, 3}}}));
  const Reach reach = walk_almonds(s.cdt, s.almonds);
  for (std::uint32_t k = 0; k < s.almonds.size(); ++k) {
    EXPECT_EQ(reach.known_of(k).front().vertex, s.almonds[k].u);
    EXPECT_EQ(reach.known_of(k).back().vertex, s.almonds[k].v);
  }
  // Flatter: the circle through (-4, 3) and (4, 3) over a chord seen under more than 120 degrees.
  const Stages flat(testing::boundary_of(
      {{{-12, 5}, {12, 5}, {5, 12}, {0, 13}, {-5, 12}}}));  // all on x^2 + y^2 = 169
  const Reach on_circle = walk_almonds(flat.cdt, flat.almonds);
  for (std::uint32_t k = 0; k < flat.almonds.size(); ++k) {
    const bool lower = flat.almonds[k].from.y == 5 && flat.almonds[k].to.y == 5;
    if (!lower || !flat.almonds[k].passes_apex()) continue;
    EXPECT_EQ(on_circle.known_of(k).size(), 5U);
  }
}

TEST(LayArcs, NeighboursInASquareMeetOnTheDiagonals) {
  const Stages s(square());
  const ArcLayer arcs = lay_arcs(s.cdt, s.almonds, 1);
  EXPECT_EQ(arcs.points.size(), 8U);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(arcs.of(k).size(), 4U);
  for (std::size_t v = 4; v < 8; ++v) {
    EXPECT_NEAR(std::abs(arcs.points[v].x - 0.5), std::abs(arcs.points[v].y - 0.5), 1e-15);
  }
}

TEST(LayArcs, AnEquilateralTriangleHasOneMeeting) {
  // The three capped arcs pass through one point.
  const Stages s(testing::boundary_of({{{0, 0}, {1, 0}, {0.5, 0.8}}}));
  const ArcLayer arcs = lay_arcs(s.cdt, s.almonds, 1);
  std::vector<std::uint32_t> meetings;
  for (const ArcVertex& v : arcs.vertices) {
    if (v.vertex >= 3) meetings.push_back(v.vertex);
  }
  ASSERT_EQ(meetings.size(), 3U);
  EXPECT_EQ(meetings[0], meetings[1]);
  EXPECT_EQ(meetings[0], meetings[2]);
}

TEST(LayArcs, WhatASideHidesDoesNotMeet) {
  // Two facing sides with a wall between them: their arcs would cross without it.
  const auto boundary =
      testing::boundary_of({{{0, 0}, {1, 0}, {1, 0.4}, {0, 0.4}}, {{0.05, 0.2}, {0.95, 0.2}}});
  const Stages s(boundary);
  const ArcLayer arcs = lay_arcs(s.cdt, s.almonds, 1);
  for (std::size_t v = boundary.points.size(); v < arcs.points.size(); ++v) {
    const Point p = arcs.points[v];
    EXPECT_FALSE(std::abs(p.y - 0.2) < 1e-12 && p.x > 0.05 && p.x < 0.95) << p.x;
  }
}

TEST(CutChords, PaperCutsIntoSixths) {
  const Stages s(testing::boundary_of({testing::regular_polygon(40)}));
  EXPECT_EQ(s.count(ChordKind::exterior), 240U);
  EXPECT_EQ(s.count(ChordKind::interior), 0U);
  EXPECT_TRUE(s.layer.faults.empty());
}

TEST(CutChords, InteriorChordsComeInPairs) {
  const Stages s(square());
  EXPECT_EQ(s.count(ChordKind::interior), 8U);  // from each corner to the meeting next to it, twice
  for (const ArcChord& c : s.layer.chords) {
    if (c.kind != ChordKind::interior) continue;
    EXPECT_EQ(std::count_if(s.layer.chords.begin(), s.layer.chords.end(),
                            [&](const ArcChord& d) { return d.a == c.b && d.b == c.a; }),
              1);
  }
}

TEST(CutChords, TheTwoSidesOfASlitAreNoPartners) {
  const auto boundary =
      testing::boundary_of({{{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, {{-0.5, 0}, {0.5, 0}}});
  std::vector<Almond> almonds = Stages(boundary).almonds;
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  for (Almond& a : almonds) a.kind = AlmondKind::none;
  const ChordLayer layer = cut_chords(lay_arcs(cdt, almonds, 1), almonds, {});
  for (const ArcChord& c : layer.chords) EXPECT_EQ(c.kind, ChordKind::fixed);
}

TEST(LongestPiece, IsTheProvenConstantWhereNothingIsToSpare) {
  CutRule rule;
  for (const double almond_nu : {kPi / 3, 1e-3, 1e-9}) {
    rule.nu = almond_nu / 2;
    // g - 1/2 with k = 0.495: sqrt(0.495) - 1/2 as nu goes to 0, a little more at 60 degrees.
    EXPECT_NEAR(rule.longest_piece(almond_nu), std::sqrt(kCentre) - 0.5, 0.01);
    EXPECT_GT(rule.longest_piece(almond_nu), 0.2);  // five pieces
    rule.nu = almond_nu / 10;
    EXPECT_EQ(rule.longest_piece(almond_nu), 0.5);
  }
}

TEST(FindRemainder, AreasAddUp) {
  for (const int n : {4, 5, 7, 12, 50}) {
    Stages s(testing::boundary_of({testing::regular_polygon(n)}));
    const Remainder r = find_remainder(s.layer, s.almonds, {});
    ASSERT_TRUE(r.faults.empty()) << n;
    double area = 0;
    const auto add = [&](Point a, Point b, Point c) { area += cross(b - a, c - a) / 2; };
    for (const Triangle& f : r.cdt.triangles) {
      add(r.cdt.points[f.v[0]], r.cdt.points[f.v[1]], r.cdt.points[f.v[2]]);
    }
    std::vector<Point> points = s.layer.points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    SplitChords none;
    none.first.assign(s.layer.chords.size() + 1, 0);
    EXPECT_TRUE(triangulate_almonds(s.almonds, s.layer, none, s.rule, points, triangles).empty());
    for (const auto& t : triangles) add(points[t[0]], points[t[1]], points[t[2]]);
    EXPECT_NEAR(area, testing::area_of(s.boundary), 1e-14) << n;
  }
}

TEST(TriangulateAlmonds, PaperCentreSeesTheSideUnderThePromisedAngle) {
  const Stages s(testing::boundary_of({testing::regular_polygon(20)}));
  std::vector<Point> points = s.layer.points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  SplitChords none;
  none.first.assign(s.layer.chords.size() + 1, 0);
  ASSERT_TRUE(triangulate_almonds(s.almonds, s.layer, none, s.rule, points, triangles).empty());
  EXPECT_EQ(points.size() - s.layer.points.size(), 20U);  // a centre each
  double least = 4;
  for (const auto& t : triangles) {
    const Point a = points[t[0]], b = points[t[1]], c = points[t[2]];
    least = std::min({least, nu_at(b, a, c), nu_at(c, b, a), nu_at(a, c, b)});
  }
  EXPECT_NEAR(least, kPi / 6, 1e-12);
}

TEST(FindRemainder, NamesTheAlmondsOfChordsThatCross) {
  Stages s(square());
  // Push a cut of one arc far into the opposite almond.
  const auto chord = std::find_if(s.layer.chords.begin(), s.layer.chords.end(), [&](const auto& c) {
    return c.kind == ChordKind::exterior && c.b >= 8;
  });
  ASSERT_NE(chord, s.layer.chords.end());
  s.layer.points[chord->b] = {0.5, 3};
  const Remainder r = find_remainder(s.layer, s.almonds, {});
  EXPECT_FALSE(r.faults.empty());
}

}  // namespace
}  // namespace cover
