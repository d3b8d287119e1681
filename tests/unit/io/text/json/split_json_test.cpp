// What is split is what a parser would find; what cannot be split is left to it.
#include "io/text/json/split_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <optional>
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

TEST(ReadPair, FindsWhatAParserFinds) {
  for (const char* text : {"[1,2]", " [ -0 , 0.0 ]", "[-0.0,1e3]", "[0.1,123456789012345678]",
                           "[1E+5,2.5e-300]", "[9007199254740993,-9007199254740993]",
                           "[4.9e-322,1.7976931348623157e308]", "[\t1 ,\n2 ]"}) {
    const std::string_view element = std::string_view(text).substr(text[0] == ' ' ? 1 : 0);
    const std::optional<Point> p = read_pair(element);
    if (!p) {
      EXPECT_NE(element.find("e-322"), element.npos) << text;  // left to the parser
      continue;
    }
    const Json json = Json::parse(element);
    EXPECT_EQ(p->x, json[0].get<double>()) << text;
    EXPECT_EQ(p->y, json[1].get<double>()) << text;
    EXPECT_EQ(std::signbit(p->x), std::signbit(json[0].get<double>())) << text;
  }
  EXPECT_EQ(read_integer_pair("[ 3 , -4 ]"), (std::array<long, 2>{3, -4}));
}

TEST(ReadPair, LeavesTheRestToTheParser) {
  for (const char* text : {"",          "[",       "[]",        "[1]",
                           "[1,2",      "[1,2,3]", "[1,2] ",    "[01,2]",
                           "[1.,2]",    "[.5,2]",  "[+1,2]",    "[1,nan]",
                           "[inf,1]",   "[1e,2]",  "[1e999,2]", "[1,99999999999999999999]",
                           "[\"1\",2]", "{}",      "[1 2]",     "[--1,2]",
                           "[-,2]",     "[0x1,2]", "null"}) {
    EXPECT_FALSE(read_pair(text)) << text;
    EXPECT_FALSE(read_integer_pair(text)) << text;
  }
  EXPECT_FALSE(read_integer_pair("[1.0,2]"));
  EXPECT_FALSE(read_integer_pair("[1,2e0]"));
}

}  // namespace
}  // namespace cover
