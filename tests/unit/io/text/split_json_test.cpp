// What is split is what a parser would find; what cannot be split is left to it.
#include "io/text/split_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <string>

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
  ASSERT_EQ(split->elements.size(), whole["features"].size());
  for (std::size_t k = 0; k < split->elements.size(); ++k)
    EXPECT_EQ(Json::parse(split->elements[k]), whole["features"][k]);
  EXPECT_EQ(rest["features"], Json::array());
  EXPECT_EQ(rest["a"], whole["a"]);
  EXPECT_EQ(rest["last"], whole["last"]);
}

TEST(SplitJson, KnowsEmptyArrays) {
  const auto split = split_json(R"({"features":[ ]})", {"features"});
  ASSERT_TRUE(split);
  EXPECT_TRUE(split->elements.empty());
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

}  // namespace
}  // namespace cover
