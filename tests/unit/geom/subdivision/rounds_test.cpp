#include "geom/subdivision/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace cover {
namespace {

TEST(Rounds, HaveEveryNumberOnce) {
  for (const std::size_t n : {0U, 1U, 2U, 9U, 1000U}) {
    std::vector<std::uint32_t> order = rounds(n), all(n);
    std::iota(all.begin(), all.end(), 0U);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, all);
  }
}

TEST(Rounds, AreFewAndEachIsSpreadOverAll) {
  constexpr std::size_t kSize = 100000;
  const std::vector<std::uint32_t> order = rounds(kSize);
  std::size_t descents = 0;
  for (std::size_t k = 1; k < kSize; ++k) descents += order[k] < order[k - 1];
  EXPECT_LE(descents, 8U);
  // What comes in the first hundredth leaves no gap of a tenth.
  std::vector<std::uint32_t> first(order.begin(), order.begin() + kSize / 100);
  first.insert(first.end(), {0, kSize});
  std::sort(first.begin(), first.end());
  for (std::size_t k = 1; k < first.size(); ++k) EXPECT_LT(first[k] - first[k - 1], kSize / 10);
}

}  // namespace
}  // namespace cover
