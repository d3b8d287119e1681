#include "io/input/attribute_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cover {
namespace {

TEST(AttributeTable, ColumnsAreNumbersOrWords) {
  AttributeTable table({"height", "use", "mixed"});
  EXPECT_EQ(table.add_feature(), 1U);
  table.set(0, 2.5);
  table.set(1, "field");
  table.set(2, 7.0);
  EXPECT_EQ(table.add_feature(), 2U);
  table.set(2, "seven");
  EXPECT_EQ(table.add_feature(), 3U);
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
    table.add_feature();
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

TEST(AttributeTable, WithoutColumnsThereAreNoFeatures) {
  AttributeTable table({});
  EXPECT_EQ(table.add_feature(), 0U);
  EXPECT_TRUE(table.attributes().empty());
}

TEST(AttributeTable, WhatNoFeatureHasIsEmpty) {
  AttributeTable table({"a", "b"});
  table.add_feature();
  table.set(1, 0.0);
  EXPECT_TRUE(table.is_empty(0));
  EXPECT_FALSE(table.is_empty(1));
}

}  // namespace
}  // namespace cover
