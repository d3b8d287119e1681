#include "clean/ends/loose_ends.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/inputs/inputs.hpp"
#include "support/inputs/soups.hpp"

namespace cover {
namespace {

using testing::clean;

/// A square of four lines, of which no two share a point, with ends that miss each other by `gap`.
Input four_lines(double gap) {
  return testing::segments_between(
      {{0, 0}, {8, 0}, {8, gap}, {8, 8}, {8, 8 + gap}, {0, 8}, {gap, 8}, {0, gap}},
      {{0, 1}, {2, 3}, {4, 5}, {6, 7}});
}

TEST(LooseEnds, AreJoinedWithinUnitsInTheLastPlace) {
  const double unit = std::nextafter(8, 9) - 8;
  const auto out = clean(four_lines(2 * unit));
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 1U);
  EXPECT_EQ(out->pslg.points.size(), 4U);
  EXPECT_TRUE(out->tells("was moved by"));
  Options strict;
  strict.strict = true;
  EXPECT_FALSE(clean(four_lines(2 * unit), strict));
  Options off;
  off.weld = 0;
  EXPECT_FALSE(clean(four_lines(2 * unit), off));
}

TEST(LooseEnds, FartherOnesAreNot) {
  const auto out = clean(four_lines(1e-12));
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().code, ErrorCode::nothing_enclosed);
}

TEST(LooseEnds, ClosedLinesNearEachOtherStay) {
  const double unit = std::nextafter(8, 9) - 8;
  Input input = testing::segments_between({{0, 0}, {8, 0}, {4, 8}, {8 + unit, 0}, {9, 8}, {12, 0}},
                                          {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}});
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->pslg.points.size(), 6U);
}

TEST(LooseEnds, WhatIsLeftOpenBesideSmallGapsIsRefusedWithAdvice) {
  // One square is closed, the other misses itself by more than rounding.
  Input input = four_lines(1e-10);
  const Input closed = testing::segments_between({{20, 0}, {21, 0}, {21, 1}, {20, 1}},
                                                 {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const auto first = static_cast<std::uint32_t>(input.points.size());
  input.points.insert(input.points.end(), closed.points.begin(), closed.points.end());
  for (InputSegment s : closed.segments) {
    s.a += first;
    s.b += first;
    input.segments.push_back(s);
  }
  const auto out = clean(input);
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().code, ErrorCode::nothing_enclosed);
  EXPECT_NE(out.error().message.find("--weld auto"), std::string::npos) << out.error().message;
  Options options;
  options.weld = 0x1p-30;
  const auto welded = clean(input, options);
  ASSERT_TRUE(welded) << welded.error().message;
  EXPECT_EQ(welded->table.regions.size(), 2U);
  options.weld = 0;
  const auto asked = clean(input, options);
  ASSERT_TRUE(asked) << asked.error().message;
  EXPECT_EQ(asked->table.regions.size(), 1U);
}

}  // namespace
}  // namespace cover
