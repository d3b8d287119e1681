#include "layers/layered_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <cover/cover_mesh.hpp>
#include <cover/verify_layers.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

/// A box of height h below and above the x axis, which is the line 'gate', cut into n from 0 to w.
Input two_boxes(int n, double w, double h) {
  std::vector<Point> points{{0, -h}, {w, -h}, {w, h}, {0, h}};
  std::vector<std::array<std::uint32_t, 2>> ends{{0, 1}, {2, 3}};
  for (int k = 0; k <= n; ++k) points.push_back({w * k / n, 0});
  const auto last = static_cast<std::uint32_t>(points.size() - 1);
  for (const auto& side : {std::array{1U, last}, {last, 2U}, {3U, 4U}, {4U, 0U}})
    ends.push_back(side);
  const std::size_t walls = ends.size();
  for (std::uint32_t k = 4; k < last; ++k) ends.push_back({k, k + 1});
  Input input = testing::segments_between(points, ends);
  for (std::size_t s = walls; s < ends.size(); ++s) input.segments[s].name = "gate";
  input.seeds.push_back({{w / 2, h / 2}, "1", "above", {}, 0, 0});
  input.seeds.push_back({{w / 2, -h / 2}, "2", "below", {}, 1, 0});
  return input;
}

Options with_layers(std::vector<LayerRule> rules) {
  Options options;
  options.layers = std::move(rules);
  return options;
}

const RegionReport& report_of(const Output& output, std::string_view region) {
  for (const RegionReport& report : output.report.regions) {
    if (output.table.region(report.id).name == region) return report;
  }
  ADD_FAILURE() << region;
  return output.report.regions[0];
}

/// The heights of the vertices within 1e-9 of the abscissa, in order.
std::vector<double> heights_at(const Output& output, double x) {
  std::vector<double> heights;
  for (const Point& p : triangle_soup(output.mesh).points) {
    if (std::abs(p.x - x) < 1e-9 && p.y >= 0) heights.push_back(p.y);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

TEST(LayeredRegion, IsMeshedWithItsLayersOnBothSidesAndTheBoundHeld) {
  const Output output =
      testing::must_mesh(two_boxes(40, 1, 0.5), with_layers({{"gate", "", 1e-5, 1.5, 10}}));
  EXPECT_EQ(testing::violations(output), "");
  for (const char* name : {"above", "below"}) {
    const RegionReport& report = report_of(output, name);
    EXPECT_TRUE(report.bound_held);
    ASSERT_EQ(report.layers.size(), 1U);
    const LayerReport& layers = report.layers[0];
    EXPECT_EQ(layers.asked.line, "gate");
    EXPECT_EQ(layers.most, 10);
    EXPECT_EQ(layers.segments, 40U);
    EXPECT_EQ(layers.complete, 38U);
    EXPECT_NEAR(layers.length, 1, 1e-12);
    EXPECT_NEAR(layers.thickness, 1e-5 * (std::pow(1.5, 10) - 1) / 0.5, 1e-12);
    ASSERT_EQ(layers.cut_short.size(), 1U);
    EXPECT_EQ(layers.cut_short[0].why, LayerStop::end);
    EXPECT_EQ(layers.cut_short[0].segments, 2U);
  }
  const std::vector<double> heights = heights_at(output, 0.5);
  ASSERT_GT(heights.size(), 10U);
  double expected = 0, layer = 1e-5;
  for (std::size_t k = 1; k <= 10; ++k, layer *= 1.5) {
    expected += layer;
    EXPECT_NEAR(heights[k] / expected, 1, 1e-9) << k;
  }
}

TEST(LayeredRegion, LiesOnTheSideAskedFor) {
  const Output output =
      testing::must_mesh(two_boxes(20, 1, 0.5), with_layers({{"gate", "above", 1e-3, 1.5, 3}}));
  EXPECT_EQ(testing::violations(output), "");
  EXPECT_EQ(report_of(output, "above").layers.size(), 1U);
  EXPECT_TRUE(report_of(output, "below").layers.empty());
  const Output plain = testing::must_mesh(two_boxes(20, 1, 0.5));
  EXPECT_EQ(
      testing::shape_of(
          testing::part_of(triangle_soup(output.mesh), report_of(output, "below").id)),
      testing::shape_of(testing::part_of(triangle_soup(plain.mesh), report_of(plain, "below").id)));
}

TEST(LayeredRegion, HasNoNegativeCouplingInItsLayers) {
  const Output output =
      testing::must_mesh(two_boxes(40, 1, 0.5), with_layers({{"gate", "", 1e-5, 1.5, 10}}));
  const double top = 1e-5 * (std::pow(1.5, 10) - 1) / 0.5;
  for (const RegionReport& report : output.report.regions) {
    for (const NegativeCoupling& c : report.couplings) {
      const bool is_at_end = std::min(c.a.x, c.b.x) < 0.3 || std::max(c.a.x, c.b.x) > 0.7;
      EXPECT_TRUE(is_at_end || std::max(std::abs(c.a.y), std::abs(c.b.y)) > top * (1 - 1e-9));
    }
  }
}

TEST(LayeredRegion, SaysWhereALineHasTooFewPoints) {
  const Output output =
      testing::must_mesh(two_boxes(1, 1, 0.5), with_layers({{"gate", "", 0.01, 1.5, 3}}));
  EXPECT_EQ(testing::violations(output), "");
  const RegionReport& report = report_of(output, "above");
  ASSERT_EQ(report.layers.size(), 1U);
  EXPECT_EQ(report.layers[0].most, 0);
  EXPECT_EQ(report.layers[0].complete, 0U);
  EXPECT_TRUE(std::any_of(report.notes.begin(), report.notes.end(), [](const Note& note) {
    return note.kind == Note::Kind::warning &&
           note.message.find("layers along 'gate' are missing on 1 segment") != std::string::npos &&
           note.message.find("they taper off (--split-interfaces") != std::string::npos;
  }));
}

TEST(LayeredRegion, SaysWhereALineTurnsInwardsTooMuch) {
  Input input = testing::segments_between({{0, 0}, {4, 0}, {2.5, 3}}, {{0, 1}, {1, 2}, {2, 0}});
  for (InputSegment& s : input.segments) s.name = "rim";
  for (const bool may_cut : {false, true}) {
    Options options = with_layers({{"rim", "", 0.01, 1.5, 3}});
    if (may_cut) options.split_interfaces = Angle::degrees(150);
    const Output output = testing::must_mesh(input, options);
    const RegionReport& report = output.report.regions[0];
    ASSERT_EQ(report.layers.size(), 1U);
    EXPECT_EQ(report.layers[0].most, 0);
    EXPECT_TRUE(std::any_of(report.notes.begin(), report.notes.end(), [](const Note& note) {
      return note.message.find(
                 "they taper off towards (0, 0), where the boundary turns inwards by "
                 "130 degrees") != std::string::npos;
    }));
  }
}

TEST(LayeredRegion, WithdrawsLayersWhereTheRestWouldBreakTheBound) {
  // Little room is left between layers and a side that no vertex may cut.
  const Output output =
      testing::must_mesh(two_boxes(16, 4, 0.3), with_layers({{"gate", "", 0.05, 1, 5}}));
  EXPECT_EQ(testing::violations(output), "");
  for (const RegionReport& report : output.report.regions) {
    EXPECT_TRUE(report.bound_held);
    ASSERT_EQ(report.layers.size(), 1U);
    const auto& parts = report.layers[0].cut_short;
    EXPECT_TRUE(std::any_of(parts.begin(), parts.end(),
                            [](const auto& part) { return part.why == LayerStop::withdrawn; }));
  }
}

/// A ring between circles of 36 and 34 chords, called 'stator' and 'rotor'.
Input air_gap() {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (const auto& [n, radius] : {std::pair(36U, 10.0), std::pair(34U, 9.13)}) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t k = 0; k < n; ++k) {
      const double turn = 2 * std::numbers::pi * k / n;
      points.push_back({radius * std::cos(turn), radius * std::sin(turn)});
      ends.push_back({first + k, first + (k + 1) % n});
    }
  }
  Input input = testing::segments_between(points, ends);
  for (std::size_t s = 0; s < ends.size(); ++s)
    input.segments[s].name = s < 36 ? "stator" : "rotor";
  input.seeds.push_back({{9.6, 0}, "1", "gap", {}, 0, 0});
  input.seeds.push_back({{0, 0}, "2", "shaft", {}, 1, 0});
  return input;
}

TEST(LayeredRegion, TellsWhichLayersGaveWayToCouplingsAndWhatKeepsThem) {
  Options options = with_layers({{"rotor", "gap", 0.43, 1, 1}});
  const Output output = testing::must_mesh(air_gap(), options);
  const RegionReport& report = report_of(output, "gap");
  ASSERT_EQ(report.layers.size(), 1U);
  EXPECT_EQ(report.box.negative_inside, 0U);
  const auto& parts = report.layers[0].cut_short;
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].why, LayerStop::couplings);
  EXPECT_EQ(parts[0].segments + report.layers[0].complete, 34U);
  EXPECT_TRUE(std::any_of(report.notes.begin(), report.notes.end(), [](const Note& note) {
    return note.message.ends_with(
        "couplings inside would be negative (--couplings last keeps all that the bound allows)");
  }));

  options.couplings = Couplings::last;
  const Output kept = testing::must_mesh(air_gap(), options);
  EXPECT_TRUE(report_of(kept, "gap").bound_held);
  EXPECT_EQ(report_of(kept, "gap").layers[0].complete, 34U);

  // Of three rows some break the bound: that is the only cause there.
  options.layers = {{"rotor", "gap", 0.2, 1, 3}};
  const Output fewer = testing::must_mesh(air_gap(), options);
  const auto& rest = report_of(fewer, "gap").layers[0].cut_short;
  EXPECT_FALSE(rest.empty());
  for (const LayerReport::Short& part : rest) EXPECT_NE(part.why, LayerStop::couplings);
}

/// What is left between them is a hair thinner than a row.
TEST(LayeredRegion, FacesAnotherOneAcrossARowThatIsLeft) {
  Input input = two_boxes(20, 4, 0.49998);
  input.segments[1].name = "lid";
  Options options = with_layers({{"gate", "above", 0.1, 1, 2}, {"lid", "above", 0.1, 1, 2}});
  options.split_interfaces = Angle::degrees(90);
  options.sizes = {{"", 0.4, false}};
  options.couplings = Couplings::last;
  const Output output = testing::must_mesh(input, options);
  const RegionReport& report = report_of(output, "above");
  ASSERT_EQ(report.layers.size(), 2U);
  for (const LayerReport& line : report.layers) {
    EXPECT_EQ(line.most, 2);
    EXPECT_EQ(line.complete, line.segments);
  }

  // The lid's edges are longer, and most of them see vertices of the gate's rows at obtuse angles.
  options.couplings = Couplings::first;
  const Output mended = testing::must_mesh(input, options);
  for (const LayerReport& line : report_of(mended, "above").layers) {
    const auto found = verify_layers(mended.pslg, mended.table, triangle_soup(mended.mesh),
                                     line.asked.line, "above", options.layers);
    ASSERT_TRUE(found && found->size() == 1) << line.asked.line;
    EXPECT_EQ(line.most, found->front().most) << line.asked.line;
    EXPECT_EQ(line.fewest, found->front().fewest) << line.asked.line;
    EXPECT_EQ(line.complete, line.asked.line == "lid" ? 6U : line.segments) << line.asked.line;
    EXPECT_EQ(line.segments, line.asked.line == "lid" ? 13U : 20U) << line.asked.line;
  }
}

/// A fibre whose layers break the bound until they are mended.
TEST(LayeredRegion, TellsOfNoBoundThatIsHeldInTheEnd) {
  std::vector<Point> points{{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  std::vector<std::array<std::uint32_t, 2>> ends{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  for (std::uint32_t k = 0; k < 12; ++k) {
    const double turn = k * std::numbers::pi / 6;
    points.push_back({1.5 + 0.5 * std::cos(turn), 1 + 0.5 * std::sin(turn)});
    ends.push_back({4 + k, 4 + (k + 1) % 12});
  }
  Input input = testing::segments_between(points, ends);
  for (std::size_t s = 4; s < ends.size(); ++s) input.segments[s].name = "fib";
  const Output output = testing::must_mesh(input, with_layers({{"fib", "", 0.1, 1.2, 2}}));
  for (const RegionReport& report : output.report.regions) {
    EXPECT_TRUE(report.bound_held);
    for (const Note& note : report.notes) EXPECT_NE(note.kind, Note::Kind::bound_missed);
  }
}

TEST(LayeredRegion, DependsNeitherOnThreadsNorOnTheOrderOfTheInput) {
  const Input input = two_boxes(24, 1, 0.5);
  Options options = with_layers({{"gate", "", 1e-3, 1.4, 6}});
  options.threads = 1;
  const Output one = testing::must_mesh(input, options);
  options.threads = 4;
  const Output four = testing::must_mesh(testing::shuffled(input, 5), options);
  EXPECT_EQ(testing::shape_of(triangle_soup(one.mesh)),
            testing::shape_of(triangle_soup(four.mesh)));
}

TEST(LayeredRegion, WorksWithTheAlmondMethod) {
  Options options = with_layers({{"gate", "", 1e-3, 1.4, 6}});
  options.method = Method::almond;
  const Output output = testing::must_mesh(two_boxes(24, 1, 0.5), options);
  EXPECT_EQ(testing::violations(output), "");
  EXPECT_EQ(report_of(output, "above").layers[0].most, 6);
}

}  // namespace
}  // namespace cover
