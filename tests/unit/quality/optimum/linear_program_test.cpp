#include "quality/optimum/linear_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

double largest_slack(const LinearFunctions& f, const std::vector<double>& step) {
  double value = -1e300;
  for (std::size_t k = 0; k < f.count(); ++k) {
    const double* row = &f.rows[k * (f.dimension + 1)];
    double here = row[0];
    for (std::size_t j = 0; j < f.dimension; ++j) here += row[1 + j] * step[j];
    value = std::max(value, here);
  }
  return value;
}

TEST(LinearProgram, GoesToACornerOfTheBox) {
  const LinearFunctions f{2, {3, 1, -2}};
  std::vector<double> step;
  EXPECT_DOUBLE_EQ(lowest_in_box(f, step), 0);
  EXPECT_EQ(step, (std::vector<double>{-1, 1}));
}

TEST(LinearProgram, StaysWhereAllSlopesAreOpposed) {
  const LinearFunctions f{1, {2, 1, 2, -1}};
  std::vector<double> step;
  EXPECT_DOUBLE_EQ(lowest_in_box(f, step), 2);
  EXPECT_DOUBLE_EQ(step[0], 0);
}

TEST(LinearProgram, NothingInTheBoxIsLower) {
  const std::uint64_t seed = testing::test_seed(7);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 100; ++k) {
    LinearFunctions f;
    f.dimension = 1 + static_cast<std::size_t>(k % 12);
    for (std::size_t m = 0; m < 20 * (f.dimension + 1); ++m) f.rows.push_back(unit(random));
    std::vector<double> step;
    const double expected = lowest_in_box(f, step);
    ASSERT_EQ(step.size(), f.dimension);
    for (const double x : step) EXPECT_LE(std::abs(x), 1 + 1e-9);
    EXPECT_NEAR(largest_slack(f, step), expected, 1e-9);
    for (int m = 0; m < 200; ++m) {  // near by, and anywhere
      std::vector<double> other;
      for (const double x : step) {
        other.push_back(m % 2 == 0 ? unit(random) : std::clamp(x + 0.01 * unit(random), -1.0, 1.0));
      }
      EXPECT_GE(largest_slack(f, other), expected - 1e-9);
    }
  }
}

}  // namespace
}  // namespace cover
