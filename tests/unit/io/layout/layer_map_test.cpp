#include "io/layout/layer_map.hpp"

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

TEST(LayerPattern, HasNumbersOrStars) {
  EXPECT_TRUE(parse_layer_pattern("68/20")->matches({68, 20}));
  EXPECT_FALSE(parse_layer_pattern("68/20")->matches({68, 21}));
  EXPECT_TRUE(parse_layer_pattern("68")->matches({68, 21}));
  EXPECT_TRUE(parse_layer_pattern(" 68 / * ")->matches({68, 21}));
  EXPECT_TRUE(parse_layer_pattern("*/21")->matches({1, 21}));
  EXPECT_FALSE(parse_layer_pattern("*/21")->matches({1, 22}));
  for (const char* bad : {"", "/", "a", "68/", "/20", "68/20/1", "1e2", "40000", "met1"})
    EXPECT_FALSE(parse_layer_pattern(bad)) << bad;
}

TEST(LayerMap, WithoutOneEveryLayerHasItsNumbers) {
  Result<LayerMap> map = LayerMap::make({});
  ASSERT_TRUE(map);
  const NamedLayer* low = map->find({1, 300});
  const NamedLayer* high = map->find({2, 0});
  ASSERT_TRUE(low != nullptr && high != nullptr);
  EXPECT_EQ(low->name, "L1D300");
  EXPECT_LT(low->height, high->height);
}

TEST(LayerMap, TheFirstThatFitsCountsAndTheLastLiesOnTop) {
  const testing::TemporaryFolder folder;
  ReadOptions options;
  options.layer_map = {
      folder.write("a.map", "# layers\n68/20 = met1\r\n\n via 1  67/44 # last\n68/*=pins\n"),
      "5=gate"};
  Result<LayerMap> map = LayerMap::make(options);
  ASSERT_TRUE(map) << map.error().message;
  EXPECT_EQ(map->find({68, 20})->name, "met1");
  EXPECT_EQ(map->find({68, 5})->name, "pins");
  EXPECT_EQ(map->find({67, 44})->name, "via 1");
  EXPECT_EQ(map->find({5, 9})->name, "gate");
  EXPECT_EQ(map->find({6, 0}), nullptr);
  EXPECT_LT(map->find({68, 20})->height, map->find({67, 44})->height);
  EXPECT_LT(map->find({68, 5})->height, map->find({5, 9})->height);
  ASSERT_EQ(map->left_out().size(), 1U);
  EXPECT_EQ(map->left_out()[0].layer, 6);
}

TEST(LayerMap, LayersAreChosenByNameOrNumber) {
  ReadOptions options;
  options.layer_map = {"1=a", "2=b", "3/7=c"};
  options.layers = {"b", "3/7", "9/9", "d"};
  Result<LayerMap> map = LayerMap::make(options);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->find({1, 0}), nullptr);
  EXPECT_NE(map->find({2, 0}), nullptr);
  EXPECT_NE(map->find({3, 7}), nullptr);
  EXPECT_EQ(map->find({4, 0}), nullptr);
  EXPECT_EQ(map->left_out().size(), 2U);
  ASSERT_EQ(map->not_in_map().size(), 1U);
  EXPECT_EQ(map->not_in_map()[0].layer, 4);
  EXPECT_EQ(map->choices_of_nothing(), (std::vector<std::string>{"9/9", "d"}));
}

TEST(LayerMap, SaysWhatIsNoLayer) {
  const testing::TemporaryFolder folder;
  const auto message = [](const std::string& entry) {
    ReadOptions options;
    options.layer_map = {entry};
    const Result<LayerMap> map = LayerMap::make(options);
    EXPECT_FALSE(map) << entry;
    return map ? "" : map.error().message;
  };
  EXPECT_EQ(message("x/20=met1"),
            "layer-map: 'x/20=met1' is not LAYER/DATATYPE=NAME, as 68/20=met1");
  EXPECT_EQ(message("68/20="), "layer-map: '68/20=' is not LAYER/DATATYPE=NAME, as 68/20=met1");
  const std::string bad = folder.write("bad.map", "1=a\nmet1\n");
  EXPECT_EQ(message(bad), bad + ":2: 'met1=' is not LAYER/DATATYPE=NAME, as 68/20=met1");
  const std::string empty = folder.write("empty.map", "# nothing\n");
  EXPECT_EQ(message(empty), empty + ": no layer in it");
  EXPECT_NE(message("/nonexistent/a.map").find("cannot open"), std::string::npos);
}

}  // namespace
}  // namespace cover
