#include "geom/box.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "geom/ulp.hpp"

namespace cover {
namespace {

TEST(Box, HoldsWhatWasAddedAndNoMore) {
  Box box;
  EXPECT_LT(box.extent(), 0);
  box.add({3, -1});
  EXPECT_EQ(box.low, (Point{3, -1}));
  EXPECT_EQ(box.high, box.low);
  EXPECT_EQ(box.extent(), 0);
  box.add({1, 6});
  EXPECT_EQ(box.low, (Point{1, -1}));
  EXPECT_EQ(box.high, (Point{3, 6}));
  EXPECT_EQ(box.width(), 2);
  EXPECT_EQ(box.height(), 7);
  EXPECT_EQ(box.extent(), 7);
}

TEST(Box, EmptyOnesAddNothingAndMeetNothing) {
  const Box unit = box_of(std::array{Point{0, 0}, Point{3, 4}});
  Box sum;
  EXPECT_TRUE(sum.is_empty());
  EXPECT_EQ(sum.diagonal(), 0);
  EXPECT_FALSE(sum.meets(unit));
  EXPECT_FALSE(unit.meets(sum));
  EXPECT_FALSE(sum.holds({0, 0}));
  sum.include(unit);
  sum.include(Box{});
  EXPECT_EQ(sum.low, unit.low);
  EXPECT_EQ(sum.high, unit.high);
  EXPECT_EQ(sum.diagonal(), 5);
}

TEST(Box, HoldsItsSidesAndMeetsWhatTouchesIt) {
  const Box unit = box_of(std::array{Point{0, 0}, Point{1, 1}});
  EXPECT_TRUE(unit.holds({1, 0.5}));
  EXPECT_FALSE(unit.holds({1.5, 0.5}));
  EXPECT_FALSE(unit.holds({0.5, -0.5}));
  EXPECT_TRUE(unit.meets(box_of(std::array{Point{1, 1}, Point{2, 2}})));
  EXPECT_TRUE(unit.meets(box_of(std::array{Point{0.25, -1}, Point{0.5, 2}})));
  EXPECT_FALSE(unit.meets(box_of(std::array{Point{0, 1.5}, Point{1, 2}})));
  EXPECT_FALSE(unit.meets(box_of(std::array{Point{-2, 0}, Point{-1, 1}})));
}

TEST(Ulp, IsTheStepToTheNextDouble) {
  EXPECT_EQ(spacing_at(1), 0x1p-52);
  EXPECT_EQ(spacing_at(-1.5), 0x1p-52);
  EXPECT_EQ(spacing_at(0x1p60), 0x1p8);
  EXPECT_EQ(spacing_at(0), 0x1p-1074);
  EXPECT_EQ(spacing_of(std::array{Point{0.25, 3}, Point{-5, 1}}), spacing_at(5));
}

}  // namespace
}  // namespace cover
