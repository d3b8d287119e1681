#include "base/containers/buckets.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cover {
namespace {

TEST(Buckets, KeepTheOrderWithinABucket) {
  const std::vector<std::size_t> key{2, 0, 2, 0, 0};
  const Buckets buckets(3, key.size(), [&](std::size_t k) { return key[k]; });
  EXPECT_TRUE(std::ranges::equal(buckets[0], std::vector<std::size_t>{1, 3, 4}));
  EXPECT_TRUE(buckets[1].empty());
  EXPECT_TRUE(std::ranges::equal(buckets[2], std::vector<std::size_t>{0, 2}));
}

}  // namespace
}  // namespace cover
