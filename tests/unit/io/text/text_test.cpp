#include "io/text/text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace cover {
namespace {

TEST(ParseDouble, TakesWholeFieldsOnly) {
  EXPECT_EQ(parse_double("0.1"), 0.1);
  EXPECT_EQ(parse_double("+1e-7"), 1e-7);
  EXPECT_EQ(parse_double("-.5"), -0.5);
  EXPECT_FALSE(parse_double("1.5x"));
  EXPECT_FALSE(parse_double("1,5"));
  EXPECT_FALSE(parse_double(""));
  EXPECT_FALSE(parse_double("+"));
  EXPECT_FALSE(parse_double("+-1"));
}

TEST(ParseDouble, GivesInfinityOrZeroBeyondTheRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parse_double("1e999"), kInfinity);
  EXPECT_EQ(parse_double("-1e999"), -kInfinity);
  EXPECT_EQ(parse_double("1e-999"), 0.0);
  EXPECT_EQ(parse_double("1" + std::string(400, '0')), kInfinity);
  EXPECT_EQ(parse_double("0." + std::string(400, '0') + "1"), 0.0);
}

TEST(ParseInteger, RefusesFractionsAndOverflow) {
  EXPECT_EQ(parse_integer("-12"), -12);
  EXPECT_EQ(parse_integer("+7"), 7);
  EXPECT_FALSE(parse_integer("1.0"));
  EXPECT_FALSE(parse_integer("99999999999999999999"));
}

TEST(LineReader, SkipsCommentsAndCountsLines) {
  LineReader lines("# head\n\n 1  2, 3 # tail\r\n#\nlast", "file.poly", '#');
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.fields(), (std::vector<std::string_view>{"1", "2", "3"}));
  EXPECT_EQ(lines.line(), 3);
  EXPECT_EQ(lines.error(ErrorCode::syntax, "wrong").message, "file.poly:3: wrong");
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.fields().at(0), "last");
  EXPECT_EQ(lines.line(), 5);
  EXPECT_FALSE(lines.next());
}

TEST(LineReader, LeavesCommasInNumbersUnlessTheySeparate) {
  const char* text = "1,5, 2 ,\n,,3,4,\n";
  LineReader blanks(text, "a.poly", '#');
  ASSERT_TRUE(blanks.next());
  EXPECT_EQ(blanks.fields(), (std::vector<std::string_view>{"1,5", "2"}));
  ASSERT_TRUE(blanks.next());
  EXPECT_EQ(blanks.fields(), (std::vector<std::string_view>{"3,4"}));
  LineReader commas(text, "a.inp", '#', Separator::comma);
  ASSERT_TRUE(commas.next());
  EXPECT_EQ(commas.fields(), (std::vector<std::string_view>{"1", "5", "2"}));
}

TEST(ReadFile, SaysWhyItCannot) {
  const auto missing = read_file("/no/such/file.poly");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::cannot_open);
  EXPECT_EQ(missing.error().message, "cannot open /no/such/file.poly: No such file or directory");
  EXPECT_FALSE(read_file("/"));
}

}  // namespace
}  // namespace cover
