#include "almond/chords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stages.hpp"

namespace cover {
namespace {

using testing::square;
using testing::Stages;

TEST(CutChords, PaperCutsIntoSixths) {
  const Stages s(testing::boundary_of({testing::regular_polygon(40)}));
  EXPECT_EQ(s.count(ChordKind::exterior), 240U);
  EXPECT_EQ(s.count(ChordKind::interior), 0U);
  EXPECT_TRUE(s.layer.blamed.empty());
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
  for (const double almond_nu : {std::numbers::pi / 3, 1e-3, 1e-9}) {
    rule.nu = almond_nu / 2;
    // g - 1/2 with k = 0.495: sqrt(0.495) - 1/2 as nu goes to 0, a little more at 60 degrees.
    EXPECT_NEAR(rule.longest_piece(almond_nu), std::sqrt(kCentre) - 0.5, 0.01);
    EXPECT_GT(rule.longest_piece(almond_nu), 0.2);  // five pieces
    rule.nu = almond_nu / 10;
    EXPECT_EQ(rule.longest_piece(almond_nu), 0.5);
  }
}

TEST(LongestPiece, IsNeverNextToNothing) {
  // Angles beside coordinates that are no normal numbers; with them an arc had 1e9 pieces.
  CutRule rule;
  for (const double almond_nu : {5e-324, 1e-320, 1e-308}) {
    for (const double nu : {5e-324, 1e-320, 1e-308, 1e-3}) {
      rule.nu = nu;
      EXPECT_GE(rule.longest_piece(almond_nu), 1.0 / 64) << almond_nu << ", " << nu;
    }
  }
}

}  // namespace
}  // namespace cover
