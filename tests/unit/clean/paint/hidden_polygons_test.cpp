#include "clean/paint/hidden_polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/none.hpp"
#include "clean/network.hpp"
#include "geom/rings/place_in_ring.hpp"
#include "support/inputs/soups.hpp"

namespace cover {
namespace {

using testing::add_polygon;
using testing::clean;
using testing::Loop;
using testing::rectangle;

/// Regular polygons of 3 to 12 corners over each other, in a square of side 1.
Input crowd(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Input input;
  for (int p = 0; p < count; ++p) {
    const double x = between(0, 1), y = between(0, 1), radius = between(0.05, 0.35);
    const double turn = between(0, 6);
    const int corners = 3 + static_cast<int>(random() % 10);
    Loop ring;
    for (int k = 0; k < corners; ++k) {
      const double at = turn + 2 * M_PI * k / corners;
      ring.push_back({x + radius * std::cos(at), y + radius * std::sin(at)});
    }
    add_polygon(input, ring, "m" + std::to_string(p % 7));
  }
  return input;
}

std::size_t count_of(const std::vector<bool>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), true));
}

/// The polygon that is seen at a point: the last one around it.
std::uint32_t seen_at(const Input& input, Point at) {
  for (auto p = static_cast<std::uint32_t>(input.polygons.size()); p-- > 0;) {
    if (place_in(input.polygons[p].rings[0], at) != Place::outside) return p;
  }
  return kNone;
}

TEST(HiddenPolygons, WhatIsLeftOutIsSeenNowhere) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const Input input = crowd(seed, 250);
    const std::vector<bool> hidden = hidden_polygons(input, Overlap::last);
    EXPECT_GT(count_of(hidden), 80U) << "seed " << seed;
    for (int i = -80; i < 280; ++i) {
      for (int k = -80; k < 280; ++k) {
        const std::uint32_t seen = seen_at(input, {i / 200.0, k / 200.0});
        if (seen == kNone) continue;
        EXPECT_FALSE(hidden[seen]) << "seed " << seed << ", polygon " << seen;
      }
    }
    const auto out = clean(input);
    ASSERT_TRUE(out) << out.error().message;
    for (std::uint32_t p = 0; p < hidden.size(); ++p) {
      if (!hidden[p]) continue;
      EXPECT_TRUE(out->tells(name_of_polygon(input, p) + " is wholly covered by others"));
    }
  }
}

TEST(HiddenPolygons, OrderOfPaintingTurnedRound) {
  const Input input = crowd(5, 250);
  Input turned = input;
  std::reverse(turned.polygons.begin(), turned.polygons.end());
  std::vector<bool> hidden = hidden_polygons(turned, Overlap::first);
  std::reverse(hidden.begin(), hidden.end());
  EXPECT_EQ(hidden, hidden_polygons(input, Overlap::last));
}

TEST(HiddenPolygons, NoneAreLookedForInDrawingsThatAreMeant) {
  Input input;
  add_polygon(input, rectangle(1, 1, 2, 2), "under");
  add_polygon(input, rectangle(0, 0, 3, 3), "over");
  EXPECT_EQ(count_of(hidden_polygons(input, Overlap::last)), 0U);
  EXPECT_EQ(count_of(hidden_polygons(crowd(1, 250), Overlap::error)), 0U);
}

/// A crowd with `polygon` below it and a square with a hole over all, whose number comes last.
Input under_a_frame(const Loop& polygon, const Loop& hole) {
  Input input = crowd(4, 250);
  InputPolygon& below = input.polygons.front();
  below.rings = {polygon};
  add_polygon(input, rectangle(-9, -9, 9, 9), "frame").rings.push_back(hole);
  return input;
}

TEST(HiddenPolygons, HolesOfThoseAboveShowWhatIsBelow) {
  const Loop below = rectangle(2, 2, 4, 4);
  const auto is_hidden = [&](const Loop& hole) {
    return bool{hidden_polygons(under_a_frame(below, hole), Overlap::last).front()};
  };
  EXPECT_TRUE(is_hidden(rectangle(5, 5, 6, 6)));
  EXPECT_FALSE(is_hidden(rectangle(2.5, 2.5, 3, 3)));
  EXPECT_FALSE(is_hidden(rectangle(1, 1, 5, 5)));
  EXPECT_FALSE(is_hidden(rectangle(3, 3, 5, 5)));
  EXPECT_FALSE(is_hidden(rectangle(4, 2, 5, 4))) << "they touch";
}

TEST(HiddenPolygons, PriorityCountsBeforeOrder) {
  Input input = under_a_frame(rectangle(2, 2, 4, 4), rectangle(5, 5, 6, 6));
  input.polygons.front().priority = 1;
  EXPECT_FALSE(hidden_polygons(input, Overlap::last).front());
  EXPECT_TRUE(hidden_polygons(input, Overlap::last)[1]);
}

}  // namespace
}  // namespace cover
