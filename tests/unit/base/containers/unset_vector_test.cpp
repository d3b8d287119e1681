// Lists whose new items hold nothing yet.
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

#include "base/containers/unset_vector.hpp"
#include "base/run_all.hpp"

namespace cover {
namespace {

TEST(UnsetVector, KeepsWhatWasWrittenAndWritesNothingElse) {
  UnsetVector<std::uint32_t> list(4, 7);
  list.resize(1);
  list.resize(3);  // no growth: what was there is there again
  EXPECT_EQ(list[0], 7U);
  EXPECT_EQ(list[2], 7U);
  list.resize(5, 9);
  EXPECT_EQ(list[4], 9U);
}

TEST(UnsetVector, ACopyIsTheSameForAnyTeamAndHasTheRoomAskedFor) {
  UnsetVector<std::uint32_t> list(300'000);
  std::iota(list.begin(), list.end(), 5U);
  for (const unsigned workers : {1U, 3U}) {
    with_team(workers, [&](const Team& team) {
      const UnsetVector<std::uint32_t> copy = copy_of(list, team, 400'000);
      EXPECT_EQ(copy, list);
      EXPECT_GE(copy.capacity(), 400'000U);
    });
  }
}

}  // namespace
}  // namespace cover
