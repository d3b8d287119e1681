#include "io/input/attribute_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace cover {
namespace {

TEST(AttributeTable, ColumnsAreNumbersOrWords) {
  AttributeTable table({"height", "use", "mixed"});
  EXPECT_EQ(table.add_feature(0), 1U);
  table.set(0, 2.5);
  table.set(1, "field");
  table.set(2, 7.0);
  EXPECT_EQ(table.add_feature(1), 2U);
  table.set(2, "seven");
  EXPECT_EQ(table.add_feature(2), 3U);
  table.set(0, -1.0);
  table.set(1, "field");
  table.set(2, 7.0);
  const std::vector<Attribute> columns = table.attributes();
  ASSERT_EQ(columns.size(), 3U);
  EXPECT_EQ(columns[0].name, "height");
  EXPECT_FALSE(columns[0].is_text);
  EXPECT_EQ(columns[0].values[0], 2.5);
  EXPECT_TRUE(std::isnan(columns[0].values[1]));
  EXPECT_EQ(columns[0].values[2], -1);
  EXPECT_TRUE(columns[1].is_text);
  EXPECT_EQ(columns[1].words, std::vector<std::string>{"field"});
  EXPECT_EQ(columns[1].values, (std::vector<double>{1, 0, 1}));
  EXPECT_EQ(columns[2].words, (std::vector<std::string>{"7", "seven"}));
  EXPECT_EQ(columns[2].values, (std::vector<double>{1, 2, 1}));
}

TEST(AttributeTable, WholeNumbersThatNoDoubleHoldsAreWords) {
  constexpr std::int64_t kExact = std::int64_t{1} << 53;
  AttributeTable table({"parcel", "small"});
  for (const std::int64_t id : {std::int64_t{3}, kExact + 1, kExact + 2}) {
    table.add_feature(0);
    table.set(0, id);
    table.set(1, std::min(id, kExact));
  }
  const std::vector<Attribute> columns = table.attributes();
  EXPECT_TRUE(columns[0].is_text);
  EXPECT_EQ(columns[0].words,
            (std::vector<std::string>{"3", "9007199254740993", "9007199254740994"}));
  EXPECT_FALSE(columns[1].is_text);
  EXPECT_EQ(columns[1].values, (std::vector<double>{3, 0x1p53, 0x1p53}));
}

TEST(AttributeTable, LongWholeNumbersThatADoubleHoldsAreNumbers) {
  AttributeTable table({"elev", "spelled"});
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();  // no value, often
  for (const std::int64_t value : {std::int64_t{120}, kLeast, -(std::int64_t{1} << 60)}) {
    table.add_feature(0);
    table.set(0, value);
    if (value == 120)
      table.set(1, value);
    else
      table.set(1, std::to_string(value));
  }
  for (const Attribute& column : table.attributes()) {
    EXPECT_FALSE(column.is_text) << column.name;
    EXPECT_EQ(column.values, (std::vector<double>{120, -0x1p63, -0x1p60}));
  }
  std::vector<std::string> warnings;
  table.tell_mixed(warnings);
  EXPECT_TRUE(warnings.empty());
}

TEST(AttributeTable, WholeNumbersThatNoDoubleHoldsAreTold) {
  AttributeTable table({"parcel", "text"});
  table.add_feature(7);
  table.set(0, std::int64_t{5});
  table.set(1, "5");
  table.add_feature(8);
  table.set(0, std::numeric_limits<std::int64_t>::max());
  table.set(1, "9223372036854775807");
  std::vector<std::string> warnings;
  table.tell_mixed(warnings);
  EXPECT_EQ(warnings,
            std::vector<std::string>{
                "the attribute 'parcel' of feature 8 is 9223372036854775807, a whole number that "
                "no double holds: its array numbers the different values 1, 2, ..."});
}

TEST(AttributeTable, WithoutColumnsThereAreNoFeatures) {
  AttributeTable table({});
  EXPECT_EQ(table.add_feature(0), 0U);
  EXPECT_TRUE(table.attributes().empty());
}

TEST(AttributeTable, WhatNoFeatureHasIsEmpty) {
  AttributeTable table({"a", "b"});
  table.add_feature(0);
  table.set(1, 0.0);
  EXPECT_TRUE(table.is_empty(0));
  EXPECT_FALSE(table.is_empty(1));
}

std::vector<std::string> mixed(const AttributeTable& table) {
  std::vector<std::string> warnings;
  table.tell_mixed(warnings);
  return warnings;
}

TEST(AttributeTable, TextsThatSpellNumbersAreNumbersAmongNumbers) {
  AttributeTable table({"K", "code", "parcel"});
  table.add_feature(0);
  table.set(0, 1e-4);
  table.set(1, "007");
  table.set(2, std::int64_t{3});
  table.add_feature(1);
  table.set(0, " 1e-5");
  table.set(1, "8");
  table.set(2, "9007199254740993");
  const std::vector<Attribute> columns = table.attributes();
  EXPECT_FALSE(columns[0].is_text);
  EXPECT_EQ(columns[0].values, (std::vector<double>{1e-4, 1e-5}));
  EXPECT_EQ(columns[1].words, (std::vector<std::string>{"007", "8"}));
  EXPECT_EQ(columns[2].words, (std::vector<std::string>{"3", "9007199254740993"}));
  EXPECT_EQ(mixed(table).size(), 1U) << "a parcel's number that is a word is a word";
}

TEST(AttributeTable, NumbersAmongWordsAreTold) {
  AttributeTable table({"class", "plain"});
  for (const long feature : {4L, 5L, 6L}) {
    table.add_feature(feature);
    table.set(1, "word");
  }
  table.set(0, std::int64_t{7});
  EXPECT_TRUE(mixed(table).empty());
  table.add_feature(9);
  table.set(0, "x");
  EXPECT_EQ(mixed(table),
            std::vector<std::string>{
                "the attribute 'class' is a number in some features, as 7 in feature 6, and a word "
                "in others, as 'x' in feature 9: its array numbers the different values 1, 2, "
                "..."});
}

TEST(AttributeTable, WhatLinesAndPointsAloneHaveIsTold) {
  AttributeTable table({"Q", "stage", "both", "all", "none"});
  const std::uint32_t area = table.add_feature(10);
  table.set(3, 1.0);
  const std::uint32_t point = table.add_feature(11);
  for (const std::size_t k : {0U, 2U, 3U}) table.set(k, 1.0);
  const std::uint32_t line = table.add_feature(12);
  for (const std::size_t k : {1U, 2U, 3U}) table.set(k, 1.0);
  table.add_shape(area, FeatureShape::area);
  table.add_shape(point, FeatureShape::point);
  table.add_shape(line, FeatureShape::line);
  const std::string tail = ": an array of a mesh holds what areas have";
  EXPECT_EQ(table.beside_areas(0, "property"),
            "only points have the property 'Q', the first of them feature 11" + tail);
  EXPECT_EQ(table.beside_areas(1, "attribute"),
            "only lines have the attribute 'stage', the first of them feature 12" + tail);
  EXPECT_EQ(table.beside_areas(2, "property"),
            "only lines and points have the property 'both', the first of them feature 11" + tail);
  EXPECT_FALSE(table.beside_areas(3, "property"));
  EXPECT_FALSE(table.beside_areas(4, "property"));
}

}  // namespace
}  // namespace cover
