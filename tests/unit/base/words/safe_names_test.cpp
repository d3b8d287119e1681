#include "base/words/safe_names.hpp"

#include <gtest/gtest.h>

#include <set>

namespace cover {
namespace {

using Names = std::vector<std::string>;

TEST(SafeNames, KeepsWhatIsSafe) {
  EXPECT_EQ(safe_name("Si-p+.v1_x"), "Si-p_.v1_x");
  EXPECT_EQ(safe_name("SiO2"), "SiO2");
  EXPECT_EQ(safe_name(""), "unnamed");
  EXPECT_EQ(safe_name("a/b \"c\"\n"), "a_b__c__");
  EXPECT_EQ(safe_name("\xc3\xa9"), "__");
}

TEST(SafeNames, NumbersDuplicates) {
  EXPECT_EQ(unique_safe_names(Names{"Si", "Si", "oxide", "Si"}),
            (Names{"Si", "Si_2", "oxide", "Si_3"}));
}

TEST(SafeNames, MadeUpNamesTakeNobodysPlace) {
  EXPECT_EQ(unique_safe_names(Names{"a/b", "a_b", "a b", "a_b_2"}),
            (Names{"a_b_3", "a_b", "a_b_4", "a_b_2"}));
}

TEST(SafeNames, ManyEqualNamesAreAllDifferent) {
  const Names safe = unique_safe_names(Names(5000, "x y"));
  EXPECT_EQ(std::set<std::string>(safe.begin(), safe.end()).size(), 5000U);
}

TEST(SafeNames, NamesThatAreTakenAndTooLongOnes) {
  EXPECT_EQ(unique_safe_names(Names{"ALL", "x", "abcdef", "abcde", "abcdeg"}, {"ALL"}, 5),
            (Names{"ALL_2", "x", "abc_2", "abcde", "abc_3"}));
}

TEST(LegibleNames, KeepUtf8) {
  const std::string name =
      "Gr\xc3\xb6\xc3\x9f\x65 \xc2\xb5m \xe6\x97\xa5\xe6\x9c\xac \xf0\x9f\x98\x80";
  EXPECT_EQ(legible_name(name), name);
  EXPECT_EQ(legible_name(""), "unnamed");
  EXPECT_EQ(legible_name("a\"b\n\t\x7f"), "a_b___");
  // Cut off, overlong, a surrogate, beyond the last, a lone follower.
  EXPECT_EQ(legible_name("x\xe6\x97"), "x__");
  EXPECT_EQ(legible_name("\xc0\x80"), "__");
  EXPECT_EQ(legible_name("\xe0\x80\x80"), "___");
  EXPECT_EQ(legible_name("\xed\xa0\x80"), "___");
  EXPECT_EQ(legible_name("\xf4\x90\x80\x80"), "____");
  EXPECT_EQ(legible_name("\x80z"), "_z");
}

TEST(LegibleNames, DoNotCollide) {
  EXPECT_EQ(unique_legible_names(Names{"a\"", "a_", "a\n"}), (Names{"a__2", "a_", "a__3"}));
  EXPECT_EQ(unique_legible_names(Names{"\xc3\xa4", "\xc3\xa4", "\xc3\xb6"}),
            (Names{"\xc3\xa4", "\xc3\xa4_2", "\xc3\xb6"}));
}

}  // namespace
}  // namespace cover
