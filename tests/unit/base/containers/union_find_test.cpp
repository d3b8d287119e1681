#include "base/containers/union_find.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "base/run_all.hpp"

namespace cover {
namespace {

TEST(SharedUnionFind, HasTheSetsOfTheOtherByAnyNumberOfThreads) {
  constexpr std::uint32_t kNumbers = 100'000;
  std::mt19937 random(3);
  for (const std::uint32_t pairs : {0U, 1'000U, 60'000U, 400'000U}) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> united;
    for (std::uint32_t k = 0; k < pairs; ++k)
      united.emplace_back(random() % kNumbers, random() % kNumbers);
    UnionFind expected(kNumbers);
    for (const auto& [i, j] : united) expected.unite(i, j);
    for (const unsigned workers : {1U, 2U, 7U}) {
      with_team(workers, [&](const Team& team) {
        SharedUnionFind sets(kNumbers);
        team.each_range(united.size(), 1000, [&](std::size_t first, std::size_t last) {
          for (std::size_t k = first; k < last; ++k) sets.unite(united[k].first, united[k].second);
        });
        for (std::uint32_t i = 0; i < kNumbers; ++i)
          ASSERT_EQ(sets.find(i), expected.find(i)) << pairs << " by " << workers;
      });
    }
  }
}

/// One long way, which threads shorten while others hang it together.
TEST(SharedUnionFind, HangsTogetherAChain) {
  constexpr std::uint32_t kNumbers = 200'000;
  with_team(3, [&](const Team& team) {
    SharedUnionFind sets(kNumbers);
    team.each_range(kNumbers - 1, 64, [&](std::size_t first, std::size_t last) {
      for (auto k = static_cast<std::uint32_t>(last); k-- > first;) sets.unite(k + 1, k);
    });
    for (std::uint32_t i = 0; i < kNumbers; ++i) ASSERT_EQ(sets.find(i), 0U);
  });
}

}  // namespace
}  // namespace cover
