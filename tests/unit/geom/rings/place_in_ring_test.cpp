#include "geom/rings/place_in_ring.hpp"

#include <array>

#include <gtest/gtest.h>

namespace cover {
namespace {

constexpr std::array kSquare{Point{0, 0}, Point{4, 0}, Point{4, 4}, Point{0, 4}};

TEST(PlaceInRing, TellsInsideBorderAndOutside) {
  EXPECT_EQ(place_in(kSquare, {1, 2}), Place::inside);
  EXPECT_EQ(place_in(kSquare, {4, 2}), Place::border);
  EXPECT_EQ(place_in(kSquare, {0, 4}), Place::border);
  EXPECT_EQ(place_in(kSquare, {-1, 0}), Place::outside);  // a ray runs along a side
  EXPECT_EQ(place_in(kSquare, {-1, 4}), Place::outside);
  EXPECT_EQ(place_in(kSquare, {5, 2}), Place::outside);
}

TEST(PlaceInRing, DependsNotOnTheDirection) {
  constexpr std::array kTurned{Point{0, 4}, Point{4, 4}, Point{4, 0}, Point{0, 0}};
  EXPECT_EQ(place_in(kTurned, {1, 2}), Place::inside);
  EXPECT_EQ(place_in(kTurned, {-1, 2}), Place::outside);
}

TEST(PlaceInRing, IsExact) {
  constexpr std::array kFlat{Point{0, 0}, Point{1, 1}, Point{0, 1}};
  constexpr double kBelow = 0x1p-53;
  EXPECT_EQ(place_in(kFlat, {0.5, 0.5}), Place::border);
  EXPECT_EQ(place_in(kFlat, {0.5, 0.5 + kBelow}), Place::inside);
  EXPECT_EQ(place_in(kFlat, {0.5, 0.5 - kBelow}), Place::outside);
}

TEST(PlaceInRing, WhatIsGoneRoundTwiceIsOutside) {
  constexpr std::array kTwice{Point{0, 0}, Point{4, 0}, Point{4, 4}, Point{0, 4},
                              Point{0, 0}, Point{4, 0}, Point{4, 4}, Point{0, 4}};
  EXPECT_EQ(place_in(kTwice, {1, 2}), Place::outside);
}

}  // namespace
}  // namespace cover
