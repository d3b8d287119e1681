#include "base/words/characters.hpp"

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(Characters, OnlyTenAreDigits) {
  int digits = 0;
  for (int c = 0; c < 256; ++c) digits += is_digit(static_cast<char>(c)) ? 1 : 0;
  EXPECT_EQ(digits, 10);
  EXPECT_TRUE(is_digit('0') && is_digit('9'));
}

TEST(Characters, TrimmedKeepsWhatIsBetween) {
  EXPECT_EQ(trimmed(" \tone two\r\n"), "one two");
  EXPECT_EQ(trimmed("one"), "one");
  EXPECT_EQ(trimmed(" \t "), "");
  EXPECT_EQ(trimmed(""), "");
  EXPECT_EQ(trimmed("\n one", " "), "\n one") << "only what is a blank there";
}

}  // namespace
}  // namespace cover
