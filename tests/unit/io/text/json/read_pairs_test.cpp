// What is read is what a parser would find; what is no pair is left to it, wherever ranges end.
#include "io/text/json/read_pairs.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "base/run_all.hpp"

namespace cover {
namespace {

using Json = nlohmann::json;

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

template <class Number>
std::vector<std::array<Number, 2>> all_of(const Pairs<Number>& pairs) {
  std::vector<std::array<Number, 2>> all(pairs.size);
  pairs.for_each(Team(), [&](std::size_t k, const std::array<Number, 2>& pair) { all[k] = pair; });
  return all;
}

/// Several ranges of pairs of different lengths, with blanks of all kinds.
std::string many_pairs(long count) {
  std::string text = "[";
  for (long k = 0; k < count; ++k) {
    text += k == 0 ? "" : k % 3 == 0 ? " ,\n " : k % 3 == 1 ? "," : ", ";
    text += k % 2 == 0 ? fmt::format("[{},{}]", k, -k) : fmt::format("[ {}\t, {} ]", k, 7 * k);
  }
  return text;
}

void expect_many(const Pairs<long>& pairs, long count) {
  const auto all = all_of(pairs);
  ASSERT_EQ(all.size(), static_cast<std::size_t>(count));
  for (long k = 0; k < count; ++k) {
    const auto& pair = all[static_cast<std::size_t>(k)];
    ASSERT_EQ(pair, (std::array<long, 2>{k, k % 2 == 0 ? -k : 7 * k}));
  }
}

constexpr long kMany = 60'000;  // a megabyte

TEST(ReadPairs, FindsAllByAnyNumberOfThreads) {
  const std::string text = many_pairs(kMany) + " ], \"other\": [[1, 2], [3, 4]]";
  for (const unsigned workers : {1U, 2U, 3U, 7U}) {
    with_team(workers, [&](const Team& team) {
      const auto pairs = read_pairs<long>(text, 1, team);
      expect_many(pairs, kMany);
      EXPECT_TRUE(pairs.is_closed);
      EXPECT_EQ(text.substr(pairs.end, 9), "], \"other");
      EXPECT_GT(pairs.ranges.size(), 4U);
    });
  }
}

/// Behind something else pairs are none of the array, and what looks like pairs may be none.
TEST(ReadPairs, EndsWhereSomethingElseBegins) {
  for (const char* other :
       {"{\"points\": [1, 2]}", "null", "[1]", "[1, 2, 3]", "[1.5, 2]", "[[1, 2], [3, 4]]", "]",
        "\"[1, 2], [3, 4]\"", "[01, 2]", "[1, 2] 3", "\"], [5, 6]\"", ""}) {
    for (const long before : {0L, 1L, kMany}) {
      const std::string start = many_pairs(before) + (before == 0 ? "" : ",");
      std::string text = start + other;
      for (int k = 0; k < 20'000; ++k) text += ",[100000, 200000]";
      const auto pairs = read_pairs<long>(text, 1, Team());
      expect_many(pairs, before);
      EXPECT_FALSE(pairs.is_closed) << other;
      EXPECT_EQ(pairs.end, start.size()) << other;
    }
  }
}

TEST(ReadPairs, EndsWhereTheTextIsCutOff) {
  const std::string text = many_pairs(kMany);
  for (const std::size_t length : {text.size(), text.size() - 1, text.size() / 2, text.size() / 3,
                                   std::size_t{1}, std::size_t{2}}) {
    const std::string_view cut = std::string_view(text).substr(0, length);
    const auto pairs = read_pairs<long>(cut, 1, Team());
    expect_many(pairs, static_cast<long>(pairs.size));
    EXPECT_FALSE(pairs.is_closed);
    EXPECT_GE(pairs.end + 40, length);
  }
}

TEST(ReadPairs, ReadsDoublesAsAParserDoes) {
  std::string text = "[";
  for (int k = 0; k < 20'000; ++k)
    text += fmt::format("{}[{}, {}]", k == 0 ? "" : ", ", std::sin(k) * 1e-3, k % 2 == 0 ? -0 : k);
  text += "]";
  const auto pairs = read_pairs<double>(text, 1, Team());
  ASSERT_TRUE(pairs.is_closed);
  const auto expected = Json::parse(text).get<std::vector<std::array<double, 2>>>();
  EXPECT_EQ(all_of(pairs), expected);
}

}  // namespace
}  // namespace cover
