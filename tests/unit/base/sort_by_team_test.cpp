#include "base/sort_by_team.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

#include "base/run_all.hpp"

namespace cover {
namespace {

TEST(SortByTeam, SortsListsOfAllLengths) {
  std::mt19937 random(7);
  for (const std::size_t n : {0UL, 1UL, 65'535UL, 65'536UL, 65'537UL, 200'001UL}) {
    for (const unsigned most : {3U, 1'000'000'000U}) {  // with many that are equal
      std::vector<std::pair<unsigned, unsigned>> list;
      for (std::size_t k = 0; k < n; ++k) list.emplace_back(random() % most, random() % most);
      auto expected = list;
      std::sort(expected.begin(), expected.end());
      for (const unsigned workers : {1U, 2U, 3U, 7U}) {
        with_team(workers, [&](const Team& team) {
          auto sorted = list;
          sort_by_team(sorted, std::less(), team);
          EXPECT_TRUE(sorted == expected) << n << " by " << workers;
        });
      }
    }
  }
}

TEST(SortByTeam, SortsWhatIsSortedAndBackwards) {
  constexpr int kMany = 150'000;
  std::vector<int> up;
  for (int k = 0; k < kMany; ++k) up.push_back(k);
  with_team(3, [&](const Team& team) {
    for (const bool is_backwards : {false, true}) {
      std::vector<int> list = is_backwards ? std::vector<int>(up.rbegin(), up.rend()) : up;
      sort_by_team(list, std::less(), team);
      EXPECT_EQ(list, up);
      sort_by_team(list, std::greater(), team);
      EXPECT_EQ(list, std::vector<int>(up.rbegin(), up.rend()));
    }
  });
}

TEST(MergeRange, AnyRangeIsThatOfTheWhole) {
  const std::vector<int> one{1, 3, 3, 5, 9}, other{0, 3, 4, 4};
  std::vector<int> whole;
  std::merge(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(whole));
  for (const auto& [a, b] :
       {std::pair(one, other), std::pair(other, one), std::pair(one, std::vector<int>{})}) {
    std::vector<int> all = whole;
    if (b.empty()) all = one;
    for (std::size_t begin = 0; begin <= all.size(); ++begin) {
      for (std::size_t end = begin; end <= all.size(); ++end) {
        std::vector<int> range(end - begin);
        merge_range<int>(a, b, begin, range, std::less());
        EXPECT_TRUE(std::equal(range.begin(), range.end(), all.begin() + static_cast<long>(begin)));
      }
    }
  }
}

}  // namespace
}  // namespace cover
