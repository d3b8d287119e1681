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

/// A closed square, and four lines beside it that miss each other by `gap`.
Input closed_beside_open(double gap) {
  Input input = four_lines(gap);
  const Input closed = testing::segments_between({{20, 0}, {21, 0}, {21, 1}, {20, 1}},
                                                 {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const auto first = static_cast<std::uint32_t>(input.points.size());
  input.points.insert(input.points.end(), closed.points.begin(), closed.points.end());
  for (InputSegment s : closed.segments) {
    s.a += first;
    s.b += first;
    input.segments.push_back(s);
  }
  return input;
}

TEST(LooseEnds, WhatIsLeftOpenBesideSmallGapsIsRefusedWithAdvice) {
  const Input input = closed_beside_open(1e-10);
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

TEST(LooseEnds, TheToleranceThatIsAdvisedClosesWiderGaps) {
  const Input input = closed_beside_open(2e-5);  // of 21
  const auto out = clean(input);
  ASSERT_FALSE(out);
  EXPECT_NE(out.error().message.find(
                "4 segments enclose nothing, and 8 ends of lines nearly meet another, the first "
                "at (0, 0), 2e-05 away: --weld 1e-06 closes such gaps"),
            std::string::npos)
      << out.error().message;
  Options options;
  options.weld = 1e-6;
  const auto welded = clean(input, options);
  ASSERT_TRUE(welded) << welded.error().message;
  EXPECT_EQ(welded->table.regions.size(), 2U);
}

TEST(LooseEnds, NoToleranceThatLeavesNothingIsAdvised) {
  const Input input =  // two segments that are nearly one
      testing::segments_between({{0, 0}, {1, 0}, {0, 1e-12}, {1, 1e-12}}, {{0, 1}, {2, 3}});
  const auto out = clean(input);
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().message.find("--weld auto"), std::string::npos) << out.error().message;
  EXPECT_NE(out.error().message.find("--hull"), std::string::npos) << out.error().message;
}

TEST(LooseEnds, WhatStaysOutOfTheMeshIsTold) {
  const auto near = clean(closed_beside_open(0.01));
  ASSERT_TRUE(near) << near.error().message;
  EXPECT_TRUE(
      near->tells("4 segments enclose nothing and stay out of the mesh; only one segment "
                  "ends at point 0 at (0, 0), and so at 7 more points; 8 ends of lines "
                  "nearly meet another, the first at (0, 0), 0.01 away (--weld 5e-04 "
                  "closes such gaps)"));
  // Lines that are open on purpose.
  const auto far = clean(closed_beside_open(3));
  ASSERT_TRUE(far) << far.error().message;
  EXPECT_TRUE(far->tells("4 segments enclose nothing and stay out of the mesh"));
  EXPECT_FALSE(far->tells("--weld"));
}

}  // namespace
}  // namespace cover
