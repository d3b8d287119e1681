#include "cuts/before_meshing/cut_for_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "geom/vector.hpp"
#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

/// A square of size 4 with the name 'wall' on its sides from number `first` on.
Input square(std::size_t first) {
  Input input =
      testing::segments_between({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  for (std::size_t s = first; s < 4; ++s) input.segments[s].name = "wall";
  return input;
}

Options layered(int count) {
  Options options;
  options.layers = {{"wall", "", 0.01, 2, count}};
  options.split_interfaces = Angle::degrees(90);
  return options;
}

TEST(CutForLayers, LeavesSegmentsWholeUnlessTheyMayBeCut) {
  Options options = layered(3);
  options.split_interfaces.reset();
  const Result<Prepared> prepared = prepare(square(3), options);
  ASSERT_TRUE(prepared);
  EXPECT_EQ(prepared->pslg.points.size(), 4U);
}

TEST(CutForLayers, PutsPointsOnBothWallsAtTheHeightsOfLayers) {
  const Result<Prepared> prepared = prepare(square(3), layered(3));
  ASSERT_TRUE(prepared);
  for (const double y : {0.0, 4.0}) {
    for (const double x : {0.01, 0.03, 0.07}) {
      const auto& points = prepared->pslg.points;
      EXPECT_NE(std::find(points.begin(), points.end(), Point{x, y}), points.end()) << x;
    }
  }
  EXPECT_EQ(prepared->pslg.points.size(), 4U + 6);
  EXPECT_TRUE(std::any_of(prepared->report.notes.begin(), prepared->report.notes.end(),
                          [](const Note& note) { return note.kind == Note::Kind::cut; }));
  const Output output = testing::must_mesh(square(3), layered(3));
  EXPECT_EQ(testing::violations(output), "");
  EXPECT_EQ(output.report.regions[0].layers[0].complete, 1U);
  EXPECT_EQ(output.report.regions[0].layers[0].fewest, 3);
}

TEST(CutForLayers, MakesTensorBlocksInCornersOfLayeredLines) {
  for (const int count : {1, 4, 0}) {
    SCOPED_TRACE(count);
    const Output output = testing::must_mesh(square(0), layered(count));
    const RegionReport& report = output.report.regions[0];
    ASSERT_EQ(report.layers.size(), 1U);
    if (count > 0) {
      EXPECT_EQ(report.layers[0].complete, report.layers[0].segments);
      EXPECT_EQ(report.layers[0].fewest, count);
      EXPECT_EQ(report.layers[0].most, count);
    } else {
      EXPECT_GE(report.layers[0].fewest, 5);  // until there is no more room
    }
    // All is right: each corner block is a grid of rows in both directions.
    EXPECT_LE(report.quality.largest_nu.supplement().in_degrees(), 90 + 1e-6);
    EXPECT_EQ(report.box.negative_couplings, 0U);
  }
}

/// Cuts to sizes leave no piece of a wall too short for layers.
TEST(CutForLayers, ComesBeforeCutsToSizes) {
  Options options = layered(3);
  options.layers[0].first = 0.2;
  options.sizes = {{"wall", 0.25, true}};
  const Output output = testing::must_mesh(square(3), options);
  EXPECT_EQ(testing::violations(output), "");
  const LayerReport& found = output.report.regions[0].layers[0];
  EXPECT_GT(found.segments, 1U);
  EXPECT_EQ(found.complete, found.segments);
  EXPECT_EQ(found.fewest, 3);
}

/// A quarter of a disc of radius 1 around the origin: 'axis' from there to the right, 'rim' of so
/// many chords.
Input quarter(std::size_t chords) {
  std::vector<Point> points{{0, 0}};
  for (std::size_t k = 0; k <= chords; ++k) {
    const double angle =
        std::numbers::pi / 2 * static_cast<double>(k) / static_cast<double>(chords);
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  points[1] = {1, 0}, points.back() = {0, 1};
  std::vector<IndexPair> sides;
  for (std::uint32_t k = 0; k < points.size(); ++k)
    sides.push_back({k, static_cast<std::uint32_t>((k + 1) % points.size())});
  Input input = testing::segments_between(points, sides);
  input.circles = {{{0, 0}, 1}};
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const bool is_chord = s > 0 && s <= chords;
    input.segments[s].name = s == 0 ? "axis" : is_chord ? "rim" : "side";
    input.segments[s].circle = is_chord ? 1 : 0;
  }
  return input;
}

/// The heights of four rows, 0.01 and 1.4 times as thick each.
const std::vector<double> kHeights{0.01, 0.024, 0.0436, 0.07104};

TEST(CutForLayers, PutsPointsOnTheArcThatIsAWall) {
  for (const bool box_method : {false, true}) {
    SCOPED_TRACE(box_method);
    Options options;
    options.layers = {{"axis", "", 0.01, 1.4, 4}};
    options.box_method = box_method;
    if (!box_method) options.split_interfaces = Angle::degrees(90);
    const Result<Prepared> prepared = prepare(quarter(9), options);
    ASSERT_TRUE(prepared);
    const std::vector<Point>& points = prepared->pslg.points;
    for (const double height : kHeights) {
      const auto at = std::find_if(points.begin(), points.end(), [&](const Point& p) {
        return p.x > 0.5 && std::abs(p.y - height) < 1e-14;
      });
      ASSERT_NE(at, points.end()) << height;
      EXPECT_NEAR(length(*at - Point{0, 0}), 1, 1e-15) << height;
    }
    options.sizes = {{"axis", 0.1, true}};
    const Output output = testing::must_mesh(quarter(9), options);
    EXPECT_EQ(testing::violations(output), "");
    if (box_method) continue;  // the axis stays whole
    const LayerReport& layers = output.report.regions[0].layers[0];
    EXPECT_EQ(layers.complete, layers.segments);
    EXPECT_EQ(layers.fewest, 4);
  }
}

TEST(CutForLayers, TakesTheHeightsOnAChordWhoseArcHasNoRoom) {
  Input input = quarter(9);
  const double angle = std::numbers::pi / 36;  // between the first chord and its arc, in the void
  input.points.push_back({0.998 * std::cos(angle), 0.998 * std::sin(angle)});
  Options options;
  options.layers = {{"axis", "", 0.01, 1.4, 4}};
  options.split_interfaces = Angle::degrees(150);
  const Result<Prepared> prepared = prepare(input, options);
  ASSERT_TRUE(prepared);
  const Point end = quarter(9).points[2];
  for (const double height : kHeights) {
    const auto at =
        std::find_if(prepared->pslg.points.begin(), prepared->pslg.points.end(),
                     [&](const Point& p) { return p.x > 0.5 && std::abs(p.y - height) < 1e-14; });
    ASSERT_NE(at, prepared->pslg.points.end()) << height;
    EXPECT_NEAR(cross(end - Point{1, 0}, *at - Point{1, 0}), 0, 1e-15) << height;
  }
}

TEST(CutForLayers, CutsLinesAtInnerCornersAtTheFeetOfRows) {
  std::vector<Point> points;
  std::vector<IndexPair> sides;
  for (std::uint32_t k = 0; k < 6; ++k) {
    points.push_back({std::cos(std::numbers::pi / 3 * k), std::sin(std::numbers::pi / 3 * k)});
    sides.push_back({k, (k + 1) % 6});
  }
  Input input = testing::segments_between(points, sides);
  for (InputSegment& s : input.segments) s.name = "wall";
  for (const bool box_method : {false, true}) {
    SCOPED_TRACE(box_method);
    Options options = layered(4);
    options.layers[0].growth = 1.4;
    options.box_method = box_method;
    options.sizes = {{"wall", 0.1, true}};
    const Output output = testing::must_mesh(input, options);
    EXPECT_EQ(testing::violations(output), "");
    const RegionReport& report = output.report.regions[0];
    EXPECT_EQ(report.layers[0].complete, report.layers[0].segments);
    EXPECT_EQ(report.layers[0].fewest, 4);
    EXPECT_LE(report.quality.largest_nu.supplement().in_degrees(), 100);
    EXPECT_EQ(report.box.negative_couplings, 0U);
  }
}

/// Sizes cut the arc, which turns the chords at its ends after the walls got their points.
TEST(CutForLayers, HeightsAreThoseOverAnArcThatSizesCut) {
  for (const std::size_t chords : {3, 9, 45}) {
    SCOPED_TRACE(chords);
    Options options;
    options.layers = {{"rim", "", 0.01, 1.4, 4}};
    options.split_interfaces = Angle::degrees(90);
    options.sizes = {{"rim", 0.03, true}};
    const Output output = testing::must_mesh(quarter(chords), options);
    EXPECT_EQ(testing::violations(output), "");
    const LayerReport& layers = output.report.regions[0].layers[0];
    EXPECT_GT(layers.segments, 45U);
    EXPECT_EQ(layers.complete, layers.segments);
    EXPECT_EQ(layers.fewest, 4);
  }
}

/// Names two lines that are images of each other, beside layers on `top` along a part of the width.
Input periodic_cell(bool reaches_left, bool reaches_right) {
  Input input = testing::segments_between({{0, 0}, {4, 0}, {4, 2}, {3, 2}, {1, 2}, {0, 2}},
                                          {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}});
  input.segments[1].name = "right";
  input.segments[5].name = "left";
  if (reaches_right) input.segments[2].name = "top";
  if (reaches_left) input.segments[4].name = "top";
  input.periodic = {{"left", "right", PeriodicRule::Map::translation, {}, {}}};
  return input;
}

TEST(CutForLayers, CutsBothOfPeriodicSides) {
  for (const bool left : {false, true}) {
    for (const bool right : {false, true}) {
      if (!left && !right) continue;
      Options options;
      options.layers = {{"top", "", 0.05, 1.3, 5}};
      options.split_interfaces = Angle::degrees(90);
      const Input input = periodic_cell(left, right);
      const Output output = testing::must_mesh(input, options);
      const Result<std::size_t> pairs =
          verify_periodic_sides(output.pslg, output.table, input.periodic[0]);
      ASSERT_TRUE(pairs) << pairs.error().message;
      EXPECT_GE(*pairs, 7U) << left << right;  // with five layers
      EXPECT_EQ(testing::violations(output), "");
      ASSERT_EQ(output.periodic.size(), 1U);
      EXPECT_EQ(output.periodic[0].vertices.size(), *pairs);
    }
  }
}

}  // namespace
}  // namespace cover
