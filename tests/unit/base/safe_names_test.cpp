#include "base/safe_names.hpp"

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

}  // namespace
}  // namespace cover
