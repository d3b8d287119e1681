#include "quality/minimax.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "support/inputs.hpp"

namespace cover {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double largest(const std::vector<LinearPiece>& pieces, Vector step) {
  double value = -kInfinity;
  for (const LinearPiece& piece : pieces) value = std::max(value, piece.at(step));
  return value;
}

TEST(Minimax, GoesDownToTheLowestPoint) {
  // A pyramid with its top down at (1, 2), -3.
  std::vector<LinearPiece> pieces;
  for (const Vector slope : {Vector{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    pieces.push_back({-3 - dot(slope, {1, 2}), slope.x, slope.y});
  }
  const Descent down = descend(pieces, -kInfinity, 100);
  EXPECT_NEAR(down.step.x, 1, 1e-12);
  EXPECT_NEAR(down.step.y, 2, 1e-12);
  EXPECT_NEAR(down.value, -3, 1e-12);
  EXPECT_FALSE(down.is_cut_short);
}

TEST(Minimax, StopsAtTheLevelAndAtTheRadius) {
  const std::vector<LinearPiece> slope{{5, 2, 0}};
  const Descent level = descend(slope, 1, 100);
  EXPECT_DOUBLE_EQ(level.value, 1);
  EXPECT_DOUBLE_EQ(level.step.x, -2);
  EXPECT_FALSE(level.is_cut_short);
  const Descent radius = descend(slope, 1, 0.5);
  EXPECT_DOUBLE_EQ(radius.value, 4);
  EXPECT_DOUBLE_EQ(radius.step.x, -0.5);
  EXPECT_TRUE(radius.is_cut_short);
}

TEST(Minimax, NothingAroundIsLower) {
  const std::uint64_t seed = testing::test_seed(3);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 200; ++k) {
    std::vector<LinearPiece> pieces;
    for (int m = 0; m < 3 + k % 12; ++m)
      pieces.push_back({unit(random), unit(random), unit(random)});
    const double radius = 0.1 + k % 7;
    const Descent down = descend(pieces, -kInfinity, radius);
    EXPECT_NEAR(down.value, largest(pieces, down.step), 1e-9);
    EXPECT_LE(down.value, largest(pieces, {}));
    EXPECT_LE(length(down.step), radius * (1 + 1e-9));
    if (down.is_cut_short) continue;
    for (int m = 0; m < 32; ++m) {
      const Vector near = down.step + 0.01 * Vector{unit(random), unit(random)};
      EXPECT_GE(largest(pieces, near), down.value - 1e-9);
    }
  }
}

}  // namespace
}  // namespace cover
