#include "layers/layer_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include <cover/cover_mesh.hpp>
#include <cover/option_table.hpp>

#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

/// Two squares side by side, 'left' and 'right', with a contact 'gate' on top of the left one.
Input two_squares() {
  Input input = testing::segments_between({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}},
                                          {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}});
  input.seeds.push_back({{0.5, 0.5}, "Si", "left", {}, 0, 0});
  input.seeds.push_back({{1.5, 0.5}, "SiO2", "right", {}, 1, 0});
  input.segments[4].name = "gate";
  return input;
}

/// Why these layers are refused; empty if they are not.
std::string refusal(std::vector<LayerRule> rules) {
  Options options;
  options.layers = std::move(rules);
  const Result<Prepared> prepared = prepare(two_squares(), options);
  if (prepared) return "";
  EXPECT_EQ(prepared.error().code, ErrorCode::bad_option);
  return prepared.error().message;
}

TEST(LayerRules, TellTheSidesOfTheirLines) {
  const Result<Prepared> prepared = prepare(two_squares());
  ASSERT_TRUE(prepared) << prepared.error().message;
  Options options;
  options.layers = {
      {"gate", "", 0.01, 1, 3}, {"left_right", "", 0.02, 1, 3}, {"left_right", "SiO2", 0.03, 1, 3}};
  auto boundaries = split_regions(prepared->pslg, prepared->table);
  const Status status = resolve_layers(prepared->pslg, prepared->table, options, boundaries);
  ASSERT_TRUE(status) << status.error().message;
  for (const RegionBoundary& boundary : boundaries) {
    const bool left = prepared->table.region(boundary.id).name == "left";
    ASSERT_EQ(boundary.layers.size(), 4U);
    for (std::size_t s = 0; s < 4; ++s) {
      const Point a = boundary.points[boundary.sides[s][0]];
      const Point b = boundary.points[boundary.sides[s][1]];
      // The last rule for a side counts.
      const std::uint32_t expected = a.x == 1 && b.x == 1           ? (left ? 2 : 3)
                                     : left && a.y == 1 && b.y == 1 ? 1
                                                                    : 0;
      EXPECT_EQ(boundary.layers[s], expected) << a.x << ' ' << a.y;
    }
  }
}

TEST(LayerRules, WithUnknownNamesAreRefused) {
  EXPECT_EQ(refusal({{"gat", "", 0.1, 1, 1}}),
            "layers for 'gat': there is no interface, contact, outline, inner line or boundary "
            "marker of that name; did you mean 'gate'?");
  EXPECT_NE(refusal({{"nothing alike", "", 0.1, 1, 1}}).find("marker of that name; there are '"),
            std::string::npos);
  EXPECT_EQ(refusal({{"Si_SiO2", "", 0.1, 1, 1}}),
            "layers for 'Si_SiO2': there is no interface, contact, outline, inner line or boundary "
            "marker of that name; between 'Si' and 'SiO2' lies 'left_right'");
  EXPECT_EQ(refusal({{"gate", "lef", 0.1, 1, 1}}),
            "layers for 'gate' 'lef': there is no region or material of that name; did you mean "
            "'left'?");
  EXPECT_EQ(refusal({{"gate", "right", 0.1, 1, 1}}),
            "layers for 'gate@right': region 'right' is not beside that line, but 'left'");
}

TEST(LayerRules, ANameWithAnAtSignIsInQuotationMarks) {
  Input input = two_squares();
  input.segments[4].name = "gate@1";
  OptionReader unquoted, quoted;
  ASSERT_TRUE(unquoted.set(*find_option("layers"), "gate@1=0.01,1,3"));
  const Result<Prepared> refused = prepare(input, *unquoted.result());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            "layers for 'gate@1': region '1' of line 'gate' is meant; in quotation marks, "
            "\"gate@1\", it is the line of that name");
  ASSERT_TRUE(quoted.set(*find_option("layers"), "\"gate@1\"=0.01,1,3"));
  EXPECT_TRUE(prepare(input, *quoted.result()));
}

TEST(LayerRules, ThatNoRegionOrNumberCanHoldAreRefused) {
  EXPECT_EQ(refusal({{"gate", "", 0.99, 1, 1}}), "");
  EXPECT_EQ(refusal({{"gate", "", 1, 1, 1}}),
            "layers for 'gate': the first layer, 1, is no thinner than region 1 'left', which is 1 "
            "from (0, 0) to (1, 1)");
  EXPECT_NE(refusal({{"gate", "", 1e-15, 1, 1}}).find("a first layer of 1e-15 is too thin"),
            std::string::npos);
}

TEST(LayerRules, WithNumbersOutOfRangeAreRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const LayerRule& rule :
       {LayerRule{"gate", "", -0.1, 1, 1}, LayerRule{"gate", "", kNan, 1, 1},
        LayerRule{"gate", "", 0, 1, 1}, LayerRule{"gate", "", 0.1, 0.5, 1},
        LayerRule{"gate", "", 0.1, kNan, 1}, LayerRule{"gate", "", 0.1, 1, 0},
        LayerRule{"gate", "", 0.1, 1, -1}}) {
    EXPECT_NE(refusal({rule}).find("layers for 'gate': "), std::string::npos);
  }
}

TEST(LayerRules, GoNeitherWithHullsNorWithDisks) {
  Options options;
  options.layers = {{"gate", "", 0.1, 1, 1}};
  options.hull = true;
  EXPECT_FALSE(check_options(options));
  options.hull = false;
  EXPECT_TRUE(check_options(options));
  options.method = Method::nonobtuse;
  EXPECT_FALSE(check_options(options));
}

}  // namespace
}  // namespace cover
