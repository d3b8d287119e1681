#include "quality/optimum/minimax.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double largest(const LinearPieces& pieces, Vector step) {
  double value = -kInfinity;
  for (std::size_t k = 0; k < pieces.count(); ++k) value = std::max(value, pieces.at(k, step));
  return value;
}

TEST(Minimax, GoesDownToTheLowestPoint) {
  // A pyramid with its top down at (1, 2), -3.
  LinearPieces pieces;
  for (const Vector slope : {Vector{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    pieces.add(-3 - dot(slope, {1, 2}), slope);
  }
  const Descent down = descend(pieces, -kInfinity, 100);
  EXPECT_NEAR(down.step.x, 1, 1e-12);
  EXPECT_NEAR(down.step.y, 2, 1e-12);
  EXPECT_NEAR(down.value, -3, 1e-12);
  EXPECT_FALSE(down.is_cut_short);
}

TEST(Minimax, StopsAtTheLevelAndAtTheRadius) {
  LinearPieces slope;
  slope.add(5, {2, 0});
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
    LinearPieces pieces;
    for (int m = 0; m < 3 + k % 12; ++m) pieces.add(unit(random), {unit(random), unit(random)});
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

TEST(Minimax, LeavesOutWhatDoesNotMatterOrFit) {
  LinearPieces pieces;
  pieces.add_if(false, 7, {1, 0});
  EXPECT_EQ(pieces.count(), 0U);
  for (std::size_t k = 0; k <= LinearPieces::kCapacity; ++k) pieces.add(static_cast<double>(k), {});
  EXPECT_EQ(pieces.count(), LinearPieces::kCapacity);
  EXPECT_EQ(descend(pieces, -kInfinity, 1).value, static_cast<double>(LinearPieces::kCapacity - 1));
}

}  // namespace
}  // namespace cover
