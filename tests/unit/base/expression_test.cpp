#include "base/expression.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <tuple>
#include <utility>

namespace cover {
namespace {

const std::array<std::string, 3> kNames{"x", "y", "P Doping"};

double value(const std::string& text, double x = 0, double y = 0, double z = 0) {
  const Result<Expression> e = Expression::parse(text, kNames);
  EXPECT_TRUE(e) << e.error().message;
  return e ? (*e)(std::array{x, y, z}) : -1e9;
}

std::string refusal(const std::string& text) {
  const Result<Expression> e = Expression::parse(text, kNames);
  EXPECT_FALSE(e) << text;
  return e ? "" : e.error().message;
}

TEST(Expression, HasTheValueOfTheUsualPrecedence) {
  EXPECT_EQ(value("0.1 + 0.3*abs(y)", 9, -2), 0.1 + 0.3 * 2);
  EXPECT_EQ(value("1 - 2 - 3"), -4);
  EXPECT_EQ(value("8/4/2"), 1);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("--3"), 3);
  EXPECT_EQ(value("+x*(y+1)", 2, 3), 8);
  EXPECT_EQ(value("1e-3*.5"), 0.5e-3);
  EXPECT_EQ(value("min(3, x, 2)", 1), 1);
  EXPECT_EQ(value("max(3)"), 3);
  EXPECT_EQ(value("max(3, 5, 4)"), 5);
  EXPECT_EQ(value("pi"), std::numbers::pi);
  EXPECT_EQ(value("sqrt(x)", 9), 3);
  EXPECT_EQ(value("exp(x)", 1), std::exp(1.0));
  EXPECT_EQ(value("log(x)", 10), std::log(10.0));
  EXPECT_EQ(value("sin(x)+cos(y)", 1, 2), std::sin(1.0) + std::cos(2.0));
  EXPECT_EQ(value("asinh(x)-tanh(y)", 7, 2), std::asinh(7.0) - std::tanh(2.0));
  EXPECT_EQ(value("hypot(x, y - 1)", 3, 5), 5);
  EXPECT_EQ(value("2*atan2(y, x)+1", -3, 2), 2 * std::atan2(2.0, -3.0) + 1);
  EXPECT_EQ(value("hypot(hypot(x, 4), max(y, 12))", 3, 0), 13);
  EXPECT_EQ(value("2*'P Doping'", 0, 0, 4), 8);
}

TEST(Expression, NoNumbersStayNone) {
  EXPECT_TRUE(std::isnan(value("sqrt(x)", -1)));
  EXPECT_TRUE(std::isnan(value("min(sqrt(x), 1)", -1)));
  EXPECT_TRUE(std::isnan(value("max(1, log(x))", -1)));
  EXPECT_EQ(value("1/x"), INFINITY);
}

TEST(Expression, MistakesHaveColumns) {
  EXPECT_EQ(refusal("1+*y"), "'1+*y', column 3: expected a number or a name, not '*'");
  EXPECT_EQ(refusal("1+"), "'1+', column 3: a number or a name is missing at the end");
  EXPECT_EQ(refusal(""), "'', column 1: a number or a name is missing at the end");
  EXPECT_EQ(refusal("1 2"), "'1 2', column 3: '2' does not belong here");
  EXPECT_EQ(refusal("(1"), "'(1', column 3: expected ')'");
  EXPECT_EQ(refusal("abs(1,2)"), "'abs(1,2)', column 6: expected ')'");
  EXPECT_EQ(refusal("z"),
            "'z', column 1: there is no 'z'; there are x, y, P Doping, pi, and functions of "
            "something in ( )");
  EXPECT_EQ(
      refusal("2*tan(1)"),
      "'2*tan(1)', column 3: there is no function 'tan'; there are min, max, hypot, atan2, abs, "
      "asinh, cos, exp, log, sin, sqrt, tanh");
  EXPECT_EQ(refusal("hypot(1)"), "'hypot(1)', column 8: expected ','");
  EXPECT_EQ(refusal("atan2(1,2,3)"), "'atan2(1,2,3)', column 10: expected ')'");
  EXPECT_EQ(refusal("abs"),
            "'abs', column 1: there is no 'abs'; there are x, y, P Doping, pi, and functions of "
            "something in ( )");
  EXPECT_EQ(refusal("'x"), "''x', column 1: the quote has no end");
  EXPECT_EQ(refusal("1e999"), "'1e999', column 1: this is no number");
  EXPECT_NE(refusal(std::string(5000, '(')).find("column 61: too much is nested"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(5000, '-') + "1").find("too much is nested"), std::string::npos);
}

TEST(Expression, TellsWhichNamesItUses) {
  const Result<Expression> e = Expression::parse("y*2", kNames);
  ASSERT_TRUE(e);
  EXPECT_FALSE(e->uses(0));
  EXPECT_TRUE(e->uses(1));
  EXPECT_FALSE(e->uses(2));
  EXPECT_TRUE(is_function_name("asinh"));
  EXPECT_FALSE(is_function_name("min"));
  EXPECT_FALSE(is_function_name("hypot"));
}

/// A random text and its value at x = 0.75, y = -1.5, computed beside it.
std::pair<std::string, double> random_formula(std::mt19937& random, int depth) {
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  if (depth == 0 || pick(6) == 0) {
    if (pick(3) == 0) return {"x", 0.75};
    if (pick(2) == 0) return {" y", -1.5};
    const int n = pick(9);
    return {std::to_string(n) + ".25", n + 0.25};
  }
  const auto [a, u] = random_formula(random, depth - 1);
  const auto [b, v] = random_formula(random, depth - 1);
  switch (pick(10)) {
    case 0:
      return {"(" + a + "+" + b + ")", u + v};
    case 1:
      return {"(" + a + " - " + b + ")", u - v};
    case 2:
      return {"(" + a + ")*(" + b + ")", u * v};
    case 3:
      return {"(" + a + ")/(" + b + ")", u / v};
    case 4:
      return {"min(" + a + ", " + b + ")", u <= v ? u : u > v ? v : NAN};
    case 5:
      return {"max(" + a + "," + b + ")", u >= v ? u : u < v ? v : NAN};
    case 6:
      return {"(-(" + a + "))", -u};
    case 7:
      return {"hypot(" + a + "," + b + ")", std::hypot(u, v)};
    case 8:
      return {"atan2(" + a + ", " + b + ")", std::atan2(u, v)};
    default:
      return {"tanh(" + a + ")", std::tanh(u)};
  }
}

TEST(Expression, RandomFormulas) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    // A product, and what stands beside it, in parentheses: the value does not depend on rules.
    const auto [text, expected] = random_formula(random, 6);
    if (std::isfinite(expected)) {
      EXPECT_EQ(value("(" + text + ")", 0.75, -1.5), expected) << "seed " << seed << ": " << text;
    }
  }
}

/// Whatever stands there, there is an end and no crash.
TEST(Expression, RandomTexts) {
  constexpr std::string_view kPieces[] = {"(", ")",    "+",    "-",      "^", "*", "/", ",", "x",
                                          "1", "min(", "abs(", "atan2(", "'", " ", ".", "e", "\0"};
  std::size_t read = 0;
  for (unsigned seed = 0; seed < 20000; ++seed) {
    std::mt19937 random(seed);
    std::string text;
    for (auto k = random() % 40; k > 0; --k) text += kPieces[random() % std::size(kPieces)];
    const Result<Expression> e = Expression::parse(text, kNames);
    if (!e) continue;
    ++read;
    std::ignore = (*e)(std::array{1.0, 2.0, 3.0});
  }
  EXPECT_GT(read, 50U);
}

}  // namespace
}  // namespace cover
