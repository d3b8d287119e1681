#include "io/text/token_reader.hpp"

#include <gtest/gtest.h>

namespace cover {
namespace {

const std::string kSource = "a.msh";

TEST(TokenReader, ReadsOverLineBreaks) {
  TokenReader tokens("$A 1\n\n -2.5e-3\r\n\"two words\" $EndA", kSource);
  EXPECT_EQ(tokens.word(), "$A");
  EXPECT_EQ(tokens.integer("n"), 1);
  EXPECT_EQ(tokens.real("x"), -2.5e-3);
  EXPECT_EQ(tokens.line(), 3);
  EXPECT_EQ(tokens.quoted("a name"), "two words");
  tokens.expect("$EndA");
  EXPECT_FALSE(tokens.failed());
  EXPECT_EQ(tokens.word(), "");
}

TEST(TokenReader, KeepsTheFirstErrorWithItsLine) {
  TokenReader tokens("1\n2\nthree 4", kSource);
  tokens.integer("a number");
  tokens.integer("a number");
  tokens.integer("a number");
  tokens.expect("five");
  ASSERT_TRUE(tokens.failed());
  EXPECT_EQ(tokens.error().message, "a.msh:3: expected a number, found 'three'");
  EXPECT_EQ(tokens.error().code, ErrorCode::syntax);
}

TEST(TokenReader, RefusesCountsThatCannotBe) {
  TokenReader huge("999999999999 1 2 3", kSource);
  EXPECT_EQ(huge.count("nodes"), 0u);
  EXPECT_EQ(huge.error().message, "a.msh:1: the file is too short for 999999999999 nodes");
  TokenReader negative("-4", kSource);
  EXPECT_EQ(negative.count("nodes"), 0u);
  EXPECT_EQ(negative.error().message, "a.msh:1: nodes is negative: -4");
}

TEST(TokenReader, TellsTheEndFromRubbish) {
  TokenReader end("  \n ", kSource);
  end.real("x");
  EXPECT_EQ(end.error().code, ErrorCode::truncated);
  TokenReader infinite("1e999", kSource);
  infinite.real("x");
  EXPECT_EQ(infinite.error().code, ErrorCode::non_finite_coordinate);
  TokenReader quote("\"open", kSource);
  quote.quoted("a name");
  EXPECT_EQ(quote.error().message, "a.msh:1: expected a name in double quotes");
  TokenReader section("1 2 3", kSource);
  section.skip_past("$End");
  EXPECT_EQ(section.error().message, "a.msh:1: the file ends before $End");
}

}  // namespace
}  // namespace cover
