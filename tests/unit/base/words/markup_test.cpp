#include <cover/text.hpp>

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(EscapedMarkup, WritesWhatMeansSomethingAsEntities) {
  EXPECT_EQ(escaped_markup("<b a=\"1\">A & B</b>"), "&lt;b a=&quot;1&quot;&gt;A &amp; B&lt;/b&gt;");
}

TEST(EscapedMarkup, IsWellFormedWhateverTheTextIs) {
  EXPECT_EQ(escaped_markup("a\x01<\xff"), "a\\x01&lt;\\xff");
}

TEST(EscapedMarkup, LeavesTheRestAsItIs) {
  EXPECT_EQ(escaped_markup(""), "");
  EXPECT_EQ(escaped_markup("Größe µm 日本 'x'"), "Größe µm 日本 'x'");
}

}  // namespace
}  // namespace cover
