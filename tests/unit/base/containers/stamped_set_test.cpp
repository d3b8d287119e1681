#include "base/containers/stamped_set.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace cover {
namespace {

TEST(StampedSet, HasWhatWasPutInSinceItWasEmptied) {
  std::mt19937 random(5);
  std::uint32_t size = 20;
  StampedSet set(size);
  EXPECT_FALSE(set.contains(0));
  std::set<std::uint32_t> expected;
  for (int step = 0; step < 2000; ++step) {
    if (random() % 10 == 0) {
      set.clear();
      expected.clear();
    }
    if (random() % 50 == 0) set.resize(++size);
    const auto k = static_cast<std::uint32_t>(random() % size);
    set.insert(k);
    expected.insert(k);
    for (std::uint32_t j = 0; j < size; ++j) ASSERT_EQ(set.contains(j), expected.contains(j)) << j;
  }
}

}  // namespace
}  // namespace cover
