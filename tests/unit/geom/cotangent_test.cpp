#include "geom/cotangent.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace cover {
namespace {

TEST(Cotangent, TellsTheAngle) {
  constexpr double kPi = std::numbers::pi, kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(angle_of_cot(0), kPi / 2);
  EXPECT_EQ(angle_of_cot(1), kPi / 4);
  EXPECT_EQ(angle_of_cot(-1), 3 * kPi / 4);
  EXPECT_EQ(angle_of_cot(kInfinity), 0);
  EXPECT_EQ(angle_of_cot(-kInfinity), kPi);
}

TEST(Cotangent, IsToldByTheAngle) {
  for (const double angle : {1e-6, 0.3, 1.0, 1.5, 2.0, 3.1})
    EXPECT_NEAR(angle_of_cot(cot_of(angle)), angle, 1e-15);
  EXPECT_EQ(cot_of(0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace cover
