#include "base/words/parse_number.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cover {
namespace {

TEST(ParseNumber, TakesTheWholeText) {
  EXPECT_EQ(parse_number<int>("-12"), -12);
  EXPECT_EQ(parse_number<double>("1e3"), 1000);
  for (const char* text : {"", "12x", " 12", "1.5", "+12", "x"})
    EXPECT_FALSE(parse_number<int>(text)) << text;
  EXPECT_FALSE(parse_number<int>("12345678901"));
  EXPECT_FALSE(parse_number<double>("1e999"));
}

TEST(ParseNumber, LeavesOutOnePlus) {
  EXPECT_EQ(without_plus("+12"), "12");
  for (const char* text : {"", "+", "12", "+-12", "++12"}) EXPECT_EQ(without_plus(text), text);
}

TEST(ParseNumber, OutOfRangeIsZeroOrInfinite) {
  EXPECT_EQ(nearest_in_range("1e999"), kInfinity);
  EXPECT_EQ(nearest_in_range("-1E+999"), -kInfinity);
  EXPECT_EQ(nearest_in_range("1e-999"), 0);
  EXPECT_TRUE(std::signbit(nearest_in_range("-1e-999")));
  EXPECT_EQ(nearest_in_range("0.000"), 0);
  EXPECT_EQ(nearest_in_range("-1000"), -kInfinity);
}

}  // namespace
}  // namespace cover
