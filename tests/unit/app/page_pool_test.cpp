#include "memory/page_pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "base/run_all.hpp"

namespace cover::app {
namespace {

#ifdef __linux__

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

std::span<std::uint64_t> words_of(void* array, std::size_t bytes) {
  return {static_cast<std::uint64_t*>(array), bytes / sizeof(std::uint64_t)};
}

void fill(void* array, std::size_t bytes, std::uint64_t with) {
  std::ranges::fill(words_of(array, bytes), with);
}

bool holds(void* array, std::size_t bytes, std::uint64_t value) {
  return std::ranges::all_of(words_of(array, bytes), [&](std::uint64_t w) { return w == value; });
}

TEST(PagePool, MakesAnArrayFromPagesOfSeveralOthers) {
  PagePool pool;
  std::vector<void*> small;
  for (std::uint64_t k = 0; k < 16; ++k) {
    small.push_back(pool.take(kMegabyte));
    fill(small.back(), kMegabyte, k + 1);
  }
  for (const std::size_t k : {3U, 7U, 12U}) EXPECT_TRUE(pool.give(small[k]));
  EXPECT_EQ(pool.kept(), 3 * kMegabyte);
  void* const large = pool.take(4 * kMegabyte);
  EXPECT_EQ(pool.kept(), 0);
  EXPECT_EQ(pool.used(), 17 * kMegabyte);
  // Nobody has cleared them: that is the point.
  std::vector<std::uint64_t> found;
  for (std::size_t k = 0; k < 4; ++k) {
    char* const part = static_cast<char*>(large) + k * kMegabyte;
    found.push_back(*reinterpret_cast<std::uint64_t*>(part));
    EXPECT_TRUE(holds(part, kMegabyte, found.back()));
  }
  std::ranges::sort(found);
  EXPECT_EQ(found, (std::vector<std::uint64_t>{0, 4, 8, 13}));
  fill(large, 4 * kMegabyte, 99);
  for (std::uint64_t k = 0; k < 16; ++k) {
    if (k == 3 || k == 7 || k == 12) continue;
    EXPECT_TRUE(holds(small[k], kMegabyte, k + 1));
  }
}

TEST(PagePool, KeepsAQuarterOfTheMostThatWereInUse) {
  PagePool pool;
  std::vector<void*> arrays;
  for (int k = 0; k < 8; ++k) arrays.push_back(pool.take(kMegabyte));
  for (void* const array : arrays) EXPECT_TRUE(pool.give(array));
  EXPECT_EQ(pool.used(), 0);
  EXPECT_EQ(pool.kept(), 2 * kMegabyte);
  EXPECT_TRUE(pool.release());
  EXPECT_EQ(pool.kept(), 0);
  EXPECT_FALSE(pool.release());
}

/// Many arrays put together from parts of others would end as pages that are moved one by one.
TEST(PagePool, KeepsNoPieceThatIsTooSmallToBeMoved) {
  PagePool pool;
  void* const most = pool.take(8 * kMegabyte);
  void* const first = pool.take(kMegabyte);
  EXPECT_TRUE(pool.give(first));
  // From the beginning of what is kept, and all of it, as what is left would be of no use.
  void* const shorter = pool.take(kMegabyte - 65536);
  EXPECT_EQ(shorter, first);
  EXPECT_EQ(pool.kept(), 0);
  EXPECT_EQ(pool.used(), 9 * kMegabyte);
  EXPECT_TRUE(pool.give(shorter));
  EXPECT_EQ(pool.kept(), kMegabyte);
  // Moved, and the rest from the system, to which it goes back.
  void* const longer = pool.take(kMegabyte + 65536);
  EXPECT_EQ(pool.kept(), 0);
  EXPECT_EQ(pool.used(), 9 * kMegabyte + 65536);
  fill(longer, kMegabyte + 65536, 7);
  EXPECT_TRUE(pool.give(longer));
  EXPECT_EQ(pool.kept(), kMegabyte);
  // The last piece that is moved leaves too little.
  void* const other = pool.take(kMegabyte / 2 * 3);
  EXPECT_TRUE(pool.give(other));
  void* const parted = pool.take(kMegabyte / 8 * 11);
  fill(parted, kMegabyte / 8 * 11, 8);
  EXPECT_EQ(pool.used(), 8 * kMegabyte + kMegabyte / 8 * 11);
  EXPECT_EQ(pool.kept(), 0);
  EXPECT_TRUE(holds(parted, kMegabyte / 8 * 11, 8));
  EXPECT_TRUE(pool.give(parted));
  EXPECT_TRUE(pool.give(most));
}

TEST(PagePool, KnowsItsArrays) {
  PagePool pool;
  std::vector<char> other(100);
  EXPECT_FALSE(pool.give(other.data()));
  void* const array = pool.take(1);
  EXPECT_FALSE(pool.give(static_cast<char*>(array) + 1));
  EXPECT_TRUE(pool.give(array));
  EXPECT_FALSE(pool.give(array));
}

TEST(PagePool, HasNoMoreThanTheSystem) {
  PagePool pool;
  void* const array = pool.take(kMegabyte);
  EXPECT_EQ(pool.take(std::size_t{1} << 60), nullptr);
  EXPECT_EQ(pool.used(), kMegabyte);
  EXPECT_TRUE(pool.give(array));
}

/// Arrays of any sizes that come and go keep what was written to them.
TEST(PagePool, HoldsForAnyNumberOfThreads) {
  PagePool pool;
  run_all(6, 3, [&](std::size_t k) {
    struct Array {
      void* at;
      std::size_t bytes;
      std::uint64_t value;
    };
    Random random(700 + k);
    std::vector<Array> arrays;
    for (std::uint64_t step = 0; step < 400; ++step) {
      if (arrays.size() < 6) {
        const std::size_t bytes = 4096 * (1 + random.below(200)) - 8 * random.below(3);
        arrays.push_back({pool.take(bytes), bytes, 1000 * (k + 1) + step});
        fill(arrays.back().at, bytes, arrays.back().value);
      } else {
        const std::size_t which = random.below(arrays.size());
        const Array array = arrays[which];
        EXPECT_TRUE(holds(array.at, array.bytes, array.value));
        EXPECT_TRUE(pool.give(array.at));
        arrays.erase(arrays.begin() + static_cast<std::ptrdiff_t>(which));
      }
    }
    for (const Array& array : arrays) {
      EXPECT_TRUE(holds(array.at, array.bytes, array.value));
      EXPECT_TRUE(pool.give(array.at));
    }
  });
  EXPECT_EQ(pool.used(), 0);
}

#endif

}  // namespace
}  // namespace cover::app
