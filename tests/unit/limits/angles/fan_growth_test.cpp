#include "limits/angles/fan_growth.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using namespace testing;

constexpr double kOneDegree = std::numbers::pi / 180;

TEST(FanGrowth, OneTriangleIsExact) {
  const FanGrowth growth({100 * kOneDegree, 20 * kOneDegree});
  // Angles 70, 90 and 20: 90 is allowed, and 20 is the least.
  EXPECT_NEAR(growth.log_ratio(70 * kOneDegree, 70 * kOneDegree),
              std::max(std::log(1 / std::sin(20 * kOneDegree)),
                       growth.log_ratio(35 * kOneDegree, 35 * kOneDegree) * 2),
              1e-6);
  // Angles 30 at the vertex, then 50 and 100, not 20 and 130.
  EXPECT_NEAR(growth.log_ratio(30 * kOneDegree, 30 * kOneDegree),
              std::log(std::sin(100 * kOneDegree) / std::sin(50 * kOneDegree)), 1e-6);
}

TEST(FanGrowth, NoTrianglesWithoutRoom) {
  const FanGrowth growth({100 * kOneDegree, 20 * kOneDegree});
  EXPECT_LT(growth.log_ratio(0, 19 * kOneDegree), 0);
  EXPECT_GE(growth.log_ratio(0, 21 * kOneDegree), 0);
  // Above 100 degrees there must be two triangles, and then 40 each are possible.
  EXPECT_GE(growth.log_ratio(101 * kOneDegree, 101 * kOneDegree), 0);
  const FanGrowth stiff({70 * kOneDegree, 50 * kOneDegree});
  EXPECT_LT(stiff.log_ratio(80 * kOneDegree, 90 * kOneDegree), 0);
}

// What is seen at once is what the bound says.
TEST(FanGrowth, MayLeadAsFarAsItGrows) {
  std::mt19937_64 random(test_seed(4));
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  for (int k = 0; k < 2000; ++k) {
    const FanGrowth growth({uniform(62, 150) * kOneDegree, uniform(0, 40) * kOneDegree});
    const double low = uniform(0, 200) * kOneDegree, high = low + uniform(0, 30) * kOneDegree;
    const double bound = growth.log_ratio(low, high);
    if (bound < 0) {
      EXPECT_FALSE(growth.may_lead(low, high, 1.5));
    } else if (bound < 20) {
      EXPECT_TRUE(growth.may_lead(low, high, std::exp(bound)));
      EXPECT_FALSE(growth.may_lead(low, high, std::exp(bound + 1e-6)));
    }
  }
}

// Fans side by side are a fan; with angles from a thousandth of a degree on there are more than are
// counted.
TEST(FanGrowth, TwoFansGrowNoFasterThanOneOfBoth) {
  std::mt19937_64 random(test_seed(2));
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  int compared = 0;
  for (int round = 0; round < 5000; ++round) {
    const FanGrowth growth(
        {uniform(65, 175) * kOneDegree, std::pow(10, uniform(-3, std::log10(55))) * kOneDegree});
    const double a = uniform(0, 180) * kOneDegree, b = uniform(0, 180) * kOneDegree;
    const double of_a = growth.log_ratio(a, a), of_b = growth.log_ratio(b, b);
    if (of_a < 0 || of_b < 0) continue;
    ++compared;
    const double of_both = growth.log_ratio(a + b, a + b);
    EXPECT_GE(of_both, (of_a + of_b) * (1 - 1e-6) - 1e-3);
    EXPECT_GE(growth.log_ratio(a, a + b), std::max(of_a, of_both) - 1e-3);
    for (const double enough : {0.5 * of_both, of_both, 1.1 * of_both + 1e-3}) {
      EXPECT_EQ(growth.log_ratio(a + b, a + b, enough) >= enough, of_both >= enough);
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(FanGrowth, FansOfVeryManyTrianglesAreNotBounded) {
  // Where all angles may be flat, isosceles triangles double the edge each: no walk over 1e10.
  for (const double least : {0.5, 1e-8, 1e-300}) {
    const FanGrowth growth({std::numbers::pi - least * kOneDegree, least * kOneDegree});
    EXPECT_EQ(growth.log_ratio(0, std::numbers::pi), std::numeric_limits<double>::infinity())
        << least;
  }
  const FanGrowth wide({176 * kOneDegree, 2 * kOneDegree});
  EXPECT_NEAR(wide.log_ratio(0, std::numbers::pi), 90 * std::log(2), 1);
  // Fans of few triangles keep their bound, however small the least angle is beside them.
  EXPECT_LT(FanGrowth({100 * kOneDegree, 2 * kOneDegree}).log_ratio(0, std::numbers::pi), 100);
  EXPECT_LT(FanGrowth({100 * kOneDegree, 1e-8 * kOneDegree}).log_ratio(0, 2e-8 * kOneDegree), 100);
}

TEST(FanGrowth, NoRandomFanGrowsFaster) {
  std::mt19937_64 random(test_seed(1));
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  int fans = 0;
  for (int round = 0; round < 20000; ++round) {
    const AngleRange range{uniform(65, 175) * kOneDegree, uniform(1, 55) * kOneDegree};
    const FanGrowth growth(range);
    double sum = 0, log_ratio = 0, nearest = 1, reach_sum = 0;
    bool possible = true;
    const int triangles = 1 + static_cast<int>(random() % 5);
    const double at = uniform(0, 1);
    for (int k = 0; k < triangles && possible; ++k) {
      // Often at the ends of what is allowed, where lengths grow most.
      const double phi = random() % 2 != 0U
                             ? uniform(range.least, range.most)
                             : std::max(range.least, std::numbers::pi - range.most - range.least);
      const double low = std::max(range.least, std::numbers::pi - phi - range.most);
      const double high = std::min(range.most, std::numbers::pi - phi - range.least);
      possible = low <= high && phi <= range.most;
      if (!possible) break;
      const double y = random() % 2 != 0U ? uniform(low, high) : high;
      const double z = std::numbers::pi - phi - y;
      sum += phi;
      // A point of the far side, between the two edges.
      const double part = at * phi;
      nearest = std::exp(log_ratio) * std::sin(y) / std::sin(part + y);
      reach_sum = sum - phi + part;
      if (reach_sum < std::numbers::pi / 2) {
        EXPECT_GE(nearest, growth.least_reach(reach_sum) * (1 - 1e-9));
      }
      log_ratio += std::log(std::sin(y) / std::sin(z));
    }
    if (!possible || sum > 2 * std::numbers::pi) continue;
    ++fans;
    EXPECT_LE(std::abs(log_ratio), growth.log_ratio(sum, sum) + 1e-9)
        << triangles << " triangles, angles from " << range.least / kOneDegree << " to "
        << range.most / kOneDegree << ", sum " << sum / kOneDegree;
    EXPECT_LE(std::abs(log_ratio), growth.log_ratio(sum - 0.1, sum + 0.2) + 1e-9);
  }
  EXPECT_GT(fans, 1000);
}

// The last triangle's apex may be as large as where couplings count, or small.
TEST(FanGrowth, NoRandomFanEndsAtASideThatItMayNot) {
  std::mt19937_64 random(test_seed(6));
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  int fans = 0, refused = 0;
  for (int round = 0; round < 40000; ++round) {
    const AngleRange range{uniform(65, 175) * kOneDegree, uniform(1, 45) * kOneDegree};
    const FanGrowth growth(range);
    AngleRange apex = range;
    if (random() % 2 != 0U) apex.most = std::min(range.most, std::numbers::pi / 2);
    apex.least = uniform(range.least, apex.most);
    double sum = 0, ratio = 1;
    bool is_possible = true;
    const int triangles = 1 + static_cast<int>(random() % 3);
    for (int k = 0; k < triangles; ++k) {
      const bool is_last = k + 1 == triangles;
      const double phi = uniform(range.least, range.most);
      // z is opposite to the edge that the triangle leads to.
      const AngleRange of_z = is_last ? apex : range;
      const double low = std::max(of_z.least, std::numbers::pi - phi - range.most);
      const double high = std::min(of_z.most, std::numbers::pi - phi - range.least);
      is_possible = is_possible && low <= high;
      if (!is_possible) break;
      const double z = random() % 3 == 0U ? (random() % 2 != 0U ? low : high) : uniform(low, high);
      sum += phi;
      ratio *= std::sin(z) / std::sin(phi + z);
    }
    if (!is_possible) continue;
    ++fans;
    FanGrowth::Ending ending{apex};
    EXPECT_TRUE(growth.may_end(sum - 1e-9, sum + 1e-9, ratio, ratio, ending)) << round;
    EXPECT_TRUE(growth.may_end(sum - 0.1, sum + 0.2, 0.9 * ratio, 1.1 * ratio, ending)) << round;
    // It tells more than the same without an apex.
    const double far = ratio * uniform(0.2, 5);
    if (growth.may_lead(sum - 1e-9, sum + 1e-9, std::max(far, 1 / far)) &&
        !growth.may_end(sum - 1e-9, sum + 1e-9, far, far, ending))
      ++refused;
  }
  EXPECT_GT(fans, 5000);
  EXPECT_GT(refused, fans / 50);
}

TEST(FanGrowth, TheApexOfTheOnlyTriangleTellsItsLength) {
  // 60 degrees at the vertex and 50 to 70 at the apex: from sin 50 / sin 70 to the reciprocal.
  const FanGrowth growth({90 * kOneDegree, 50 * kOneDegree});
  FanGrowth::Ending ending{{70 * kOneDegree, 50 * kOneDegree}};
  const double sum = 60 * kOneDegree;
  EXPECT_TRUE(growth.may_end(sum, sum, 1.2, 1.2, ending));
  EXPECT_FALSE(growth.may_end(sum, sum, 1.5, 1.5, ending));
  EXPECT_FALSE(growth.may_end(sum, sum, 0.6, 0.6, ending));
  EXPECT_TRUE(growth.may_end(sum, sum, 0.6, 1.1, ending));
}

}  // namespace
}  // namespace cover
