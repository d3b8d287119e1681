#include "base/words/and_more.hpp"

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(AndMore, CountsWhatIsNotNamed) {
  EXPECT_EQ(and_more(8, 5), " and 3 more");
  EXPECT_EQ(and_more(8, 5, ";"), "; and 3 more");
  EXPECT_EQ(and_more(5, 5), "");
  EXPECT_EQ(and_more(0, 5), "");
}

}  // namespace
}  // namespace cover
