// What is split is what a parser would find; what cannot be split is left to it.
#include "io/text/json/split_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace cover {
namespace {

using Json = nlohmann::json;

TEST(SplitJson, TakesTheElementsOut) {
  const std::string text =
      R"( {"a" : {"features": [1]}, "s": "x\"]}", "features" : [ {"b": [1, {"c": "}]\\"}]} , 2,"[" ],)"
      R"( "last": -1.5e3 } )";
  const auto split = split_json(text, {"polygons", "features"});
  ASSERT_TRUE(split);
  const Json whole = Json::parse(text), rest = Json::parse(split->rest);
  ASSERT_EQ(split->arrays[0].elements.size(), whole["features"].size());
  for (std::size_t k = 0; k < split->arrays[0].elements.size(); ++k)
    EXPECT_EQ(Json::parse(split->arrays[0].elements[k]), whole["features"][k]);
  EXPECT_EQ(rest["features"], Json::array());
  EXPECT_EQ(rest["a"], whole["a"]);
  EXPECT_EQ(rest["last"], whole["last"]);
}

TEST(SplitJson, KnowsEmptyArrays) {
  const auto split = split_json(R"({"features":[ ]})", {"features"});
  ASSERT_TRUE(split);
  EXPECT_TRUE(split->arrays[0].elements.empty());
}

TEST(SplitJson, LeavesTheRestToTheParser) {
  for (const char* text :
       {"", "[]", "{}", "{", R"({"features")", R"({"features": 3})", R"({"features": [1, 2)",
        R"({"features": [1,]})", R"({"features": [1 2]})", R"({"features": [{"a": "]}]})",
        R"({"other": [1]})", R"({"a" 1, "features": []})"})
    EXPECT_FALSE(split_json(text, {"features"})) << text;
}

/// Whatever stands behind the array is in the rest, right or wrong.
TEST(SplitJson, HidesNoFaultBehindTheArray) {
  const auto split = split_json(R"({"features": [1] oops})", {"features"});
  ASSERT_TRUE(split);
  EXPECT_FALSE(Json::accept(split->rest));
}

TEST(SplitJson, TakesOfEachNameTheFirst) {
  const std::string text = R"({"b":[1,2],"x":0,"a":[3],"b":[4],"c":[]})";
  const auto split = split_json(text, {"a", "b"});
  ASSERT_TRUE(split);
  ASSERT_EQ(split->arrays.size(), 2U);
  EXPECT_EQ(split->arrays[0].name, "b");
  EXPECT_EQ(split->arrays[1].name, "a");
  EXPECT_EQ(split->rest, R"({"b":[],"x":0,"a":[],"b":[4],"c":[]})");
  EXPECT_EQ(split->find("c"), nullptr);
}

/// Whoever passes elements says how far; a comma must have an element behind it.
TEST(SplitJson, GoesOnBehindWhatIsPassed) {
  const auto pass_to = [](std::size_t to, bool is_closed) {
    return [=](std::string_view, std::size_t) { return Passed{to, is_closed}; };
  };
  const std::string text = R"({"a":[1,2,3],"x":0})";
  const auto behind_one = split_json(text, {"a"}, pass_to(8, false));
  ASSERT_TRUE(behind_one);
  ASSERT_EQ(behind_one->arrays[0].elements.size(), 2U);
  EXPECT_EQ(behind_one->arrays[0].elements[0], "2");
  const auto closed = split_json(text, {"a"}, pass_to(11, true));
  ASSERT_TRUE(closed);
  EXPECT_TRUE(closed->arrays[0].elements.empty());
  EXPECT_EQ(closed->rest, R"({"a":[],"x":0})");
  EXPECT_FALSE(split_json(R"({"a":[1,]})", {"a"}, pass_to(8, false)));
}

}  // namespace
}  // namespace cover
