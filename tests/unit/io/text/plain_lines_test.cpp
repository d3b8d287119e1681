#include "io/text/plain_lines.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/run_all.hpp"

namespace cover {
namespace {

using Pair = std::pair<long, double>;

bool read_long_and_double(PlainLine& line, std::vector<Pair>& items) {
  Pair pair;
  if (!line.integer(pair.first) || !line.real(pair.second)) return false;
  items.push_back(pair);
  return true;
}

TEST(PlainLines, PassesBlanksAndEmptyLines) {
  const auto read =
      read_plain_lines<Pair>("1 2\n\n \t 3   4e1 \r\n  \n5 6", 10, read_long_and_double);
  EXPECT_EQ(read.items, (std::vector<Pair>{{1, 2}, {3, 40}, {5, 6}}));
  EXPECT_EQ(read.lines, (std::vector<int>{1, 3, 5}));
  EXPECT_EQ(read.line_count, 5);
  EXPECT_TRUE(read.is_all);
}

TEST(PlainLines, EndsBeforeWhatIsNotPlain) {
  for (const char* line :
       {"3 4 5", "3", "3 4 # here", "3, 4", "+3 4", "3 +4", "3.5 4", "3 inf", "3 nan", "3 1e999",
        "3 4x", "# 3 4", "99999999999999999999 1", "3 0x1"}) {
    const std::string text = std::string("1 2\n") + line + "\n5 6\n";
    const auto read = read_plain_lines<Pair>(text, 10, read_long_and_double);
    EXPECT_EQ(read.items, (std::vector<Pair>{{1, 2}})) << line;
    EXPECT_EQ(text.substr(read.bytes), line + std::string("\n5 6\n"));
    EXPECT_EQ(read.line_count, 1) << line;
    EXPECT_FALSE(read.is_all) << line;
  }
}

TEST(PlainLines, EndsWhenThereAreEnough) {
  const auto read = read_plain_lines<Pair>("1 2\n3 4\nx", 2, read_long_and_double);
  EXPECT_EQ(read.items.size(), 2U);
  EXPECT_EQ(read.bytes, 8U);
  EXPECT_FALSE(read.is_all);
  EXPECT_EQ(read_plain_lines<Pair>("x", 0, read_long_and_double).items.size(), 0U);
}

/// Ranges in their order, up to the line that is not plain, or to the last that was asked for.
TEST(PlainLines, RangesAreOneTextForAnyNumberOfThreads) {
  constexpr int kPlain = 100'000;
  std::string text;
  for (int k = 0; k < kPlain; ++k) text += fmt::format("{} {}\n{}", k, 0.5 * k, k % 7 ? "" : "\n");
  const std::size_t plain = text.size();
  text += "1 2 3\n";
  for (int k = 0; k < kPlain; ++k) text += "1 2\n";
  for (const std::size_t most : {std::size_t{1'000'000}, std::size_t{77'777}}) {
    for (const unsigned workers : {1U, 2U, 3U, 7U}) {
      with_team(workers, [&](const Team& team) {
        const auto parts = read_plain_ranges<Pair>(text, most, 32, read_long_and_double, team);
        EXPECT_GT(parts.size(), 3U);
        std::size_t bytes = 0;
        int next = 0, lines = 0;
        for (const auto& part : parts) {
          for (std::size_t k = 0; k < part.items.size(); ++k, ++next) {
            ASSERT_EQ(part.items[k], Pair(next, 0.5 * next));
            ASSERT_EQ(lines + part.lines[k], next + 1 + (next + 6) / 7);
          }
          bytes += part.bytes;
          lines += part.line_count;
        }
        EXPECT_EQ(next, std::min<int>(kPlain, static_cast<int>(most)));
        if (most > kPlain) {
          EXPECT_EQ(bytes, plain);
        }
        EXPECT_FALSE(parts.back().is_all);
      });
    }
  }
}

}  // namespace
}  // namespace cover
