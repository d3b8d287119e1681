#include "base/numbers_where.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "base/run_all.hpp"

namespace cover {
namespace {

TEST(NumbersWhere, ComeInOrderWhateverTheTeam) {
  const auto is_wanted = [](std::uint32_t k) { return k % 7 == 3 || k > 99'990; };
  for (const std::size_t count : {0UL, 1UL, 4UL, 32'768UL, 32'769UL, 100'000UL}) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < count; ++k) {
      if (is_wanted(k)) expected.push_back(k);
    }
    for (const unsigned workers : {1U, 3U}) {
      with_team(workers, [&](const Team& team) {
        EXPECT_EQ(numbers_where(count, is_wanted, team), expected) << count << " by " << workers;
      });
    }
  }
}

}  // namespace
}  // namespace cover
