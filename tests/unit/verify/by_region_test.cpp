#include "verify/by_region.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "base/run_all.hpp"

namespace cover {
namespace {

/// Sums, and what came first: what depends on the order is in the order of the numbers.
TEST(FoldByRegion, IsWhatALoopWouldDo) {
  constexpr std::size_t kCount = 100'000, kNone = kCount;
  struct Seen {
    std::uint64_t sum = 0;
    std::size_t first = kNone;
  };
  const auto merge = [](Seen& all, const Seen& other) {
    all.sum += other.sum;
    if (all.first == kNone) all.first = other.first;
  };
  std::mt19937 random(5);
  for (const std::uint32_t longest : {1U, 20'000U}) {  // runs of a region
    std::vector<RegionId> region;
    while (region.size() < kCount)
      region.resize(region.size() + 1 + random() % longest, RegionId{random() % 4});
    std::vector<Seen> expected(4);
    for (std::size_t k = 0; k < kCount; ++k) merge(expected[region[k].index()], {k, k});
    expected[0] = {};  // the void
    for (const unsigned workers : {1U, 3U}) {
      with_team(workers, [&](const Team& team) {
        std::vector<Seen> found(4);
        fold_by_region(
            kCount, [&](std::size_t k) { return region[k]; }, Seen{},
            [&](Seen& seen, std::size_t k) {
              merge(seen, {k, k});
            },
            merge, found, team);
        for (std::size_t r = 0; r < 4; ++r) {
          EXPECT_EQ(found[r].sum, expected[r].sum);
          EXPECT_EQ(found[r].first, expected[r].first);
        }
      });
    }
  }
}

}  // namespace
}  // namespace cover
