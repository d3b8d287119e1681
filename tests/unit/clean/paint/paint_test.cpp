#include "clean/paint/paint.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "support/inputs/soups.hpp"

namespace cover {
namespace {

using testing::add_polygon;
using testing::clean;
using testing::Cleaned;
using testing::rectangle;

/// Two unit squares that overlap in a quarter.
Input two_squares() {
  Input input;
  input.source = "deck.json";
  add_polygon(input, rectangle(0, 0, 2, 2), "a");
  add_polygon(input, rectangle(1, 1, 3, 3), "b");
  return input;
}

TEST(Paint, LaterFirstOrNone) {
  Input input = two_squares();
  auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->area("a"), 3);
  EXPECT_EQ(out->area("b"), 4);
  EXPECT_EQ(out->pslg.points.size(), 9U);  // the corner of a inside b is hidden
  Options options;
  options.overlap = Overlap::first;
  out = clean(input, options);
  EXPECT_EQ(out->area("a"), 4);
  EXPECT_EQ(out->area("b"), 3);
  options.overlap = Overlap::error;
  out = clean(input, options);
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().code, ErrorCode::overlapping_polygons);
  EXPECT_EQ(out.error().message.substr(0, 57),
            "deck.json: polygon 1 'a' and polygon 2 'b' overlap at (1.");
  ASSERT_EQ(out.error().inputs.size(), 2U);
  EXPECT_EQ(out.error().inputs[1].id, 2);
  input.polygons[0].priority = 5;
  out = clean(input, options);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->area("a"), 4);
}

TEST(Paint, LeavesOutWhatIsHidden) {
  Input input;
  add_polygon(input, rectangle(1, 1, 2, 2), "hidden");
  add_polygon(input, rectangle(0, 0, 3, 3), "top");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->pslg.segments.size(), 4U);
  ASSERT_EQ(out->table.regions.size(), 1U);
  EXPECT_EQ(out->table.regions[0].material, 2);
  EXPECT_TRUE(out->tells("polygon 1 'hidden' is wholly covered by others"));
}

TEST(Paint, UnitesWhatOnlyHiddenEdgesCut) {
  Input input;
  add_polygon(input, rectangle(1, -1, 2, 2), "below");  // crosses the bottom of the next one
  add_polygon(input, rectangle(0, -3, 3, 3), "above");
  add_polygon(input, rectangle(0, -3, 3, 0), "last");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->pslg.segments.size(), 7U);
  EXPECT_EQ(out->pslg.points.size(), 6U);
}

TEST(Paint, TakesRingsAsEvenOdd) {
  Input input;
  InputPolygon& p = add_polygon(input, rectangle(0, 0, 9, 9), "m");
  p.rings.push_back(testing::reversed(rectangle(1, 1, 8, 8)));
  p.rings.push_back(rectangle(2, 2, 3, 3));  // an island in the hole
  p.rings[0].push_back(p.rings[0].front());  // closed as GeoJSON does
  add_polygon(input, {{20, 0}, {24, 4}, {24, 0}, {20, 4}}, "bow");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->area("m"), 81 - 49 + 1);
  EXPECT_EQ(out->area("bow"), 8);
  EXPECT_EQ(out->table.regions.size(), 4U);
  EXPECT_TRUE(out->tells("polygon 2 'bow' crosses itself at (22, 2)"));
}

TEST(Paint, DropsSlitsOfARing) {
  Input input;  // a hole that is joined to the outline by an edge taken both ways
  add_polygon(input,
              {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}},
              "keyhole");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->area("keyhole"), 72);
  EXPECT_EQ(out->pslg.segments.size(), 8U);
  EXPECT_TRUE(
      out->tells("polygon 1 'keyhole' folds back on itself along 1 edge, "
                 "from (0, 0) to (3, 3): nothing is separated there"));
}

TEST(Paint, KeepsPolygonsApartUnlessNamedOrMerged) {
  Input input;
  add_polygon(input, rectangle(0, 0, 1, 1), "Si");
  add_polygon(input, rectangle(1, 0, 2, 1), "Si");
  add_polygon(input, rectangle(2, 0, 3, 1), "Si", "bulk");
  add_polygon(input, rectangle(3, 0, 4, 1), "Si", "bulk");
  auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 3U);
  EXPECT_EQ(out->table.regions[2].name, "bulk");
  EXPECT_EQ(out->table.regions[2].area, 2);
  Options merge;
  merge.merge_materials = true;
  out = clean(input, merge);
  ASSERT_TRUE(out) << out.error().message;
  ASSERT_EQ(out->table.regions.size(), 1U);
  EXPECT_EQ(out->table.regions[0].area, 4);
}

TEST(Paint, KeepsPolygonsOfOneNameApartWhereSizesOrAttributesDiffer) {
  Input input;
  for (int k = 0; k < 6; ++k) add_polygon(input, rectangle(k, 0, k + 1, 1), "grass", "meadow");
  input.polygons[1].size = 0.5;
  input.polygons[2].size = 0.5;
  const double none = std::numeric_limits<double>::quiet_NaN();
  input.attributes = {{"kf", false, {}, {1e-4, 1e-3, 1e-4, none}}};
  for (std::uint32_t k = 0; k < 5; ++k) input.polygons[k].feature = k < 3 ? 1 : k - 1;
  const auto areas = [&](const Options& options) {
    std::vector<double> found;
    const auto out = clean(input, options);
    EXPECT_TRUE(out) << out.error().message;
    for (const Region& region : out->table.regions) found.push_back(region.area);
    return found;
  };
  // By size and value: (1e-4), (0.5, 1e-4) twice, (1e-3), (1e-4), none.
  EXPECT_EQ(areas({}), (std::vector<double>{1, 2, 1, 1, 1}));
  input.polygons[4].feature = 4;  // whose value is none, as that of no feature
  EXPECT_EQ(areas({}), (std::vector<double>{1, 2, 1, 2}));
  Options merge;
  merge.merge_materials = true;
  EXPECT_EQ(areas(merge), std::vector<double>{6});
}

TEST(Paint, NamesARegionAfterAPolygonInIt) {
  Input input;
  add_polygon(input, rectangle(0, 0, 1, 1), "Si", "left");
  add_polygon(input, rectangle(1, 0, 2, 1), "SiO2");
  add_polygon(input, rectangle(2, 0, 3, 1), "Si", "right");
  add_polygon(input, rectangle(3, 0, 4, 1), "Si");
  input.polygons.push_back(input.polygons[3]);  // one polygon that shows on both sides of the oxide
  input.polygons[4].rings = {rectangle(0, 1, 1, 2), rectangle(4, 0, 5, 1)};
  Options merge;
  merge.merge_materials = true;
  const auto out = clean(input, merge);
  ASSERT_TRUE(out) << out.error().message;
  ASSERT_EQ(out->table.regions.size(), 3U);
  EXPECT_EQ(out->table.regions[0].name, "left");
  EXPECT_EQ(out->table.regions[0].area, 2);
  EXPECT_EQ(out->table.regions[2].name, "right");
  EXPECT_EQ(out->table.regions[2].area, 3);
}

TEST(Paint, TellsPolygonsWithoutAnInsideFromHiddenOnes) {
  Input input;
  InputPolygon& twice = add_polygon(input, rectangle(0, 0, 2, 2), "twice");
  twice.rings.push_back(rectangle(0, 0, 2, 2));
  add_polygon(input, {{9, 0}, {10, 0}, {11, 0}, {12, 0}}, "flat");
  InputPolygon& whole = add_polygon(input, rectangle(5, 0, 7, 2), "whole");
  whole.rings.push_back({{5.5, 1}, {6, 1}, {5.5, 1}});
  whole.rings.emplace_back();
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 1U);
  EXPECT_TRUE(out->tells("polygon 1 'twice' has no inside: its edges cancel each other"));
  EXPECT_TRUE(out->tells("polygon 2 'flat' has no inside"));
  EXPECT_TRUE(out->tells("ring 2 of polygon 3 'whole' has fewer than three different corners"));
  EXPECT_TRUE(out->tells("ring 3 of polygon 3 'whole' has fewer than three different corners"));
  EXPECT_FALSE(out->tells("polygon 3 'whole' folds back"));
}

/// Parcels along a street, with gaps as wide as a drawing's errors between them.
void add_parcels(const std::vector<double>& gaps, Input& input) {
  double x = 0;
  for (const double gap : gaps) {
    add_polygon(input, {{x, 0}, {x + 50, 0}, {x + 50, 1000}, {x, 1000}}, "parcel");
    x += 50 + gap;
  }
  add_polygon(input, {{x, 0}, {x + 50, 0}, {x + 50, 1000}, {x, 1000}}, "parcel");
  add_polygon(input, {{0, -50}, {x + 50, -50}, {x + 50, 0}, {0, 0}}, "south");
  add_polygon(input, {{0, 1000}, {x + 50, 1000}, {x + 50, 1050}, {0, 1050}}, "north");
}

TEST(Paint, AdviceOnThinVoidsLeavesOutThoseThatAreMeant) {
  Input input;
  add_parcels({0.06, 0.05, 0.02, 20, 0.03, 0.06}, input);
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(out->tells("polygons leave 5 thin voids between them, with an area of 220 together"));
  EXPECT_TRUE(out->tells("(1 far wider one is taken as meant)"));
  // 0.24 of 1100; ends of lines shorter than eight times that stay where they are.
  EXPECT_TRUE(out->tells("with --weld 3e-04, which is held back beside lines shorter than 2.64"));
  // What is advised closes them and leaves the street, which is not spoken of then.
  Options weld;
  weld.weld = 3e-4;
  const auto closed = clean(input, weld);
  ASSERT_TRUE(closed) << closed.error().message;
  EXPECT_FALSE(closed->tells("far wider"));
  EXPECT_EQ(closed->table.regions.size(), 9U);
}

/// Four blocks of four lots between streets, in a frame: all gaps are one void, thin as a whole.
TEST(Paint, AdviceOnGapsThatOpenToStreetsIsForTheGaps) {
  constexpr double kLot = 50, kGap = 0.06, kStreet = 20;
  Input input;
  const std::array<double, 4> at{0, kLot + kGap, 2 * kLot + kGap + kStreet,
                                 3 * kLot + 2 * kGap + kStreet};
  for (const double x : at) {
    for (const double y : at)
      add_polygon(input, {{x, y}, {x + kLot, y}, {x + kLot, y + kLot}, {x, y + kLot}}, "lot");
  }
  const double end = at.back() + kLot + kGap;
  add_polygon(input, {{-40, -40}, {end + 40, -40}, {end + 40, -kGap}, {-40, -kGap}}, "frame");
  add_polygon(input, {{-40, end}, {end + 40, end}, {end + 40, end + 40}, {-40, end + 40}}, "frame");
  add_polygon(input, {{-40, -kGap}, {-kGap, -kGap}, {-kGap, end}, {-40, end}}, "frame");
  add_polygon(input, {{end, -kGap}, {end + 40, -kGap}, {end + 40, end}, {end, end}}, "frame");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(out->tells("(1 far wider one is taken as meant)"));
  EXPECT_TRUE(out->tells("with --weld 8e-04")) << out->report.notes.front().message;
  Options weld;
  weld.weld = 8e-4;
  const auto closed = clean(input, weld);
  ASSERT_TRUE(closed) << closed.error().message;
  EXPECT_FALSE(closed->tells("thin void"));
}

/// A border that is off by a little does not make others, off by two hundred times it, look meant.
TEST(Paint, AdviceOnThinVoidsIsForMostOfThem) {
  Input input;
  add_parcels({0.002, 1e-5, 0.002}, input);
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(
      out->tells("polygons leave 3 thin voids between them, with an area of 4.01 together"));
  EXPECT_FALSE(out->tells("taken as meant"));
  Options weld;
  weld.weld = 8e-6;
  EXPECT_TRUE(out->tells("with --weld 8e-06")) << out->report.notes.front().message;
  EXPECT_FALSE(clean(input, weld)->tells("thin void"));
}

TEST(Paint, NoSmallerToleranceThanInForceIsAdvised) {
  Input input;
  add_parcels({0.06, 0.05}, input);
  // Lines so short that nothing is welded beside them.
  auto& ring = input.polygons[0].rings[0];
  ring = {{0, 0}, {50, 0}, {50, 0.01}, {50, 999.99}, {50, 1000}, {0, 1000}};
  Options weld;
  weld.weld = 1e-2;
  const auto out = clean(input, weld);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_FALSE(out->tells("with --weld"));
}

TEST(Paint, WarnsOfThinVoidsBetweenPolygons) {
  Input input;  // the lower one takes two chords of an arc, the upper one
  add_polygon(input, {{0, 0}, {4, 0}, {4, 2}, {2, 1.9}, {0, 2}}, "low");
  add_polygon(input, {{0, 2}, {4, 2}, {4, 4}, {0, 4}}, "up");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(out->tells("polygons leave 1 thin void between them, with an area of 0.2 together"));
  EXPECT_TRUE(out->tells("with --weld 5e-02"));
  Options weld;
  weld.weld = 5e-2;
  EXPECT_FALSE(clean(input, weld)->tells("thin void"));
  input.polygons[0].rings[0][3].y = 1;  // a cavity that is meant
  EXPECT_FALSE(clean(input)->tells("thin void"));
  input.polygons.pop_back();
  input.polygons[0].rings = {rectangle(0, 0, 4, 4), rectangle(1, 1, 3, 1.01)};
  EXPECT_FALSE(clean(input)->tells("thin void"));
}

TEST(Paint, LeavesVoidWhereNothingCovers) {
  Input input;
  add_polygon(input, rectangle(0, 0, 3, 1), "a");
  add_polygon(input, rectangle(0, 2, 3, 3), "a");
  add_polygon(input, rectangle(0, 0, 1, 3), "a");
  add_polygon(input, rectangle(2, 0, 3, 3), "a");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->area("a"), 8);
  EXPECT_EQ(out->table.void_seeds.size(), 1U);
}

}  // namespace
}  // namespace cover
