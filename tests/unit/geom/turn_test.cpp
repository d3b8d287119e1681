#include "geom/turn.hpp"

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(Turn, QuartersAreExact) {
  for (const double full : {-720.0, 0.0, 360.0}) {
    EXPECT_EQ(Turn::by_degrees(full).cosine, 1);
    EXPECT_EQ(Turn::by_degrees(full).sine, 0);
    EXPECT_EQ(Turn::by_degrees(full + 90).cosine, 0);
    EXPECT_EQ(Turn::by_degrees(full + 90).sine, 1);
    EXPECT_EQ(Turn::by_degrees(full + 180).cosine, -1);
    EXPECT_EQ(Turn::by_degrees(full - 90).sine, -1);
  }
}

TEST(Turn, ADirectionIsOneHoweverItIsGiven) {
  for (const double degrees : {330.0, 359.9, 195.0}) {
    const Turn turn = Turn::by_degrees(degrees);
    for (const double same : {degrees - 360, degrees + 360, degrees - 720}) {
      EXPECT_EQ(Turn::by_degrees(same).cosine, turn.cosine) << same;
      EXPECT_EQ(Turn::by_degrees(same).sine, turn.sine) << same;
    }
  }
  EXPECT_EQ(reduced_degrees(-1e-20), 0);
}

TEST(Turn, OnceAroundIsFullUpToRounding) {
  for (int k = -3600; k < 7200; ++k) {
    EXPECT_TRUE(is_full_turn(k / 10.0, (k + 3600) / 10.0)) << k;
    EXPECT_TRUE(is_full_turn((k + 3600) / 10.0, k / 10.0)) << k;
    EXPECT_FALSE(is_full_turn(k / 10.0, (k + 3600) / 10.0 + 1e-11)) << k;
    EXPECT_FALSE(is_full_turn(k / 10.0, k / 10.0)) << k;
  }
}

TEST(Turn, OthersAreRounded) {
  const Turn turn = Turn::by_degrees(30);
  EXPECT_NEAR(turn.cosine, std::sqrt(3) / 2, 1e-15);
  EXPECT_NEAR(turn.sine, 0.5, 1e-15);
  EXPECT_NE(Turn::by_degrees(90.0000001).cosine, 0);
}

}  // namespace
}  // namespace cover
