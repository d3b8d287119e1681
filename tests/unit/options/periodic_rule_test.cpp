#include "options/periodic_rule.hpp"

#include <limits>

#include <gtest/gtest.h>

#include <cover/option_table.hpp>

namespace cover {
namespace {

Result<PeriodicRule> parsed(const std::string& text) {
  const OptionEntry* entry = find_option("periodic");
  Options options;
  if (Status status = entry->set(*entry, text, options); !status) return std::move(status).error();
  return options.periodic.at(0);
}

TEST(PeriodicRule, IsReadInAllItsForms) {
  const Result<PeriodicRule> plain = parsed("left=right");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->from, "left");
  EXPECT_EQ(plain->to, "right");
  EXPECT_EQ(plain->map, PeriodicRule::Map::translation);
  const Result<PeriodicRule> turned = parsed("a=b@1,-2.5:45");
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->map, PeriodicRule::Map::rotation);
  EXPECT_EQ(turned->centre, (Point{1, -2.5}));
  EXPECT_EQ(turned->angle, Angle::degrees(45));
  const Result<PeriodicRule> mirrored = parsed("a=b@mirror");
  ASSERT_TRUE(mirrored);
  EXPECT_EQ(mirrored->map, PeriodicRule::Map::mirror);
  const Result<PeriodicRule> quoted = parsed("\"a=1\"=\"b@c\"@mirror");
  ASSERT_TRUE(quoted);
  EXPECT_EQ(quoted->from, "a=1");
  EXPECT_EQ(quoted->to, "b@c");
}

TEST(PeriodicRule, WhatIsNoneIsRefused) {
  for (const char* text : {"", "left", "=right", "left=", "a=b@", "a=b@1,2", "a=b@1:2", "a=b@x,y:3",
                           "a=b@mirrored", "\"a=b", "\"\"=b", "a=\"b\"c"}) {
    EXPECT_FALSE(parsed(text)) << text;
  }
}

TEST(PeriodicRule, NothingIsItsOwnImage) {
  EXPECT_TRUE(check_rule({"a", "b", PeriodicRule::Map::translation, {}, {}}));
  EXPECT_FALSE(check_rule({"a", "a", PeriodicRule::Map::translation, {}, {}}));
  EXPECT_FALSE(check_rule({"a", "", PeriodicRule::Map::mirror, {}, {}}));
  EXPECT_FALSE(check_rule({"a", "b", PeriodicRule::Map::glide, {}, {}}));
  for (const double degrees : {0.0, 360.0, -720.0, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(check_rule({"a", "b", PeriodicRule::Map::rotation, {}, Angle::degrees(degrees)}));
  EXPECT_TRUE(check_rule({"a", "b", PeriodicRule::Map::rotation, {}, Angle::degrees(180)}));
}

}  // namespace
}  // namespace cover
