#include "io/images/speckles.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace cover {
namespace {

/// A picture by letters, the lowest row first.
LabelImage image_of(const std::vector<std::string>& rows) {
  LabelImage image;
  image.width = rows.front().size();
  image.height = rows.size();
  image.names.resize(26);
  for (const std::string& row : rows)
    for (const char letter : row) image.labels.push_back(static_cast<std::uint32_t>(letter - 'a'));
  return image;
}

std::vector<std::string> rows_of(const LabelImage& image) {
  std::vector<std::string> rows(image.height);
  for (std::size_t p = 0; p < image.labels.size(); ++p)
    rows[p / image.width] += static_cast<char>('a' + image.labels[p]);
  return rows;
}

std::vector<std::string> without_speckles(const std::vector<std::string>& rows, std::size_t least) {
  LabelImage image = image_of(rows);
  take_in_speckles(image, least);
  return rows_of(image);
}

using Rows = std::vector<std::string>;

TEST(Speckles, TakeTheLabelAlongTheLongestBorder) {
  EXPECT_EQ(without_speckles({"aaaabbb", "aaacbbb", "aaaabbb"}, 2),
            (Rows{"aaaabbb", "aaaabbb", "aaaabbb"}));
  EXPECT_EQ(without_speckles({"aaabbbb", "aaacbbb", "aaabbbb"}, 2),
            (Rows{"aaabbbb", "aaabbbb", "aaabbbb"}));
}

TEST(Speckles, AreFewerPixelsThanAsked) {
  const Rows rows{"aaaa", "accb", "bbbb"};
  EXPECT_EQ(without_speckles(rows, 2), rows);
  EXPECT_EQ(without_speckles(rows, 3), (Rows{"aaaa", "aaab", "bbbb"}));
  LabelImage image = image_of(rows);
  EXPECT_EQ(take_in_speckles(image, 3), 1U);
  EXPECT_EQ(take_in_speckles(image, 3), 0U);
}

TEST(Speckles, ThatTouchAtACornerAreTwo) {
  EXPECT_EQ(without_speckles({"aaaaa", "acaaa", "aacaa", "aaaaa"}, 2),
            (Rows{"aaaaa", "aaaaa", "aaaaa", "aaaaa"}));
}

TEST(Speckles, BehindEachOtherAreTakenInFromOutside) {
  // Colours of a blend: each is small, and c has small neighbours alone.
  EXPECT_EQ(without_speckles({"aaaaaaa", "aabbbaa", "aabcbaa", "aabbbaa", "aaaaaaa"}, 9),
            (Rows{"aaaaaaa", "aaaaaaa", "aaaaaaa", "aaaaaaa", "aaaaaaa"}));
}

TEST(Speckles, AloneStayAsTheyAre) {
  const Rows rows{"abc", "def"};
  EXPECT_EQ(without_speckles(rows, 100), rows);
}

TEST(Speckles, RandomPicturesKeepNoSmallSetBesideALargeOne) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Rows rows(20, std::string(30, 'a'));
    for (std::string& row : rows)
      for (char& letter : row) letter = static_cast<char>('a' + random.below(1 + seed % 3));
    for (std::size_t y = 0; y < 20; ++y)
      for (std::size_t x = 0; x < 12; ++x) rows[y][x] = 'z';
    LabelImage image = image_of(rows);
    take_in_speckles(image, 6);
    LabelImage again = image;
    EXPECT_EQ(take_in_speckles(again, 6), 0U);
    EXPECT_EQ(again.labels, image.labels);
  }
}

}  // namespace
}  // namespace cover
