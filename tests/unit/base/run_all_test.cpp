#include "base/run_all.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/sort_by_team.hpp"

namespace cover {
namespace {

TEST(RunAll, CallsEachOnceWithAnyNumberOfWorkers) {
  for (const unsigned workers : {0U, 1U, 2U, 7U, 100U}) {
    for (const std::size_t count : {0U, 1U, 2U, 50U}) {
      std::vector<std::atomic<int>> calls(count);
      run_all(count, workers, [&](std::size_t k) { ++calls[k]; });
      for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(calls[k], 1) << k << " of " << count;
    }
  }
}

TEST(RunAll, OneWorkerIsTheCaller) {
  std::vector<std::size_t> order;
  const std::thread::id caller = std::this_thread::get_id();
  run_all(3, 1, [&](std::size_t k) {
    order.push_back(k);
    EXPECT_EQ(std::this_thread::get_id(), caller);
  });
  EXPECT_EQ(order, std::vector<std::size_t>({0, 1, 2}));
}

TEST(RunAll, SeveralWorkAtATime) {
  // The first waits for the second, which needs a thread of its own.
  std::atomic<bool> second_began = false;
  std::mutex mutex;
  std::set<std::thread::id> threads;
  run_all(2, 2, [&](std::size_t k) {
    if (k == 1) second_began = true;
    while (!second_began) std::this_thread::yield();
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(threads.size(), 2U);
}

TEST(RunAll, PartsAreSharedByAllThreadsAndMayBeDividedAgain) {
  for (const unsigned workers : {1U, 2U, 3U, 8U}) {
    std::vector<std::atomic<int>> calls(5 * 40);
    run_all(5, workers, [&](std::size_t k, const Team& team) {
      EXPECT_EQ(team.workers(), workers);
      team.each(4, [&](std::size_t part) {
        team.each(10, [&](std::size_t piece) { ++calls[40 * k + 10 * part + piece]; });
      });
    });
    for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(RunAll, OneCallGetsTheThreadsOfAll) {
  // Two parts of a single call wait for each other.
  std::atomic<int> begun = 0;
  run_all(1, 2, [&](std::size_t, const Team& team) {
    team.each(2, [&](std::size_t) {
      ++begun;
      while (begun < 2) std::this_thread::yield();
    });
  });
  EXPECT_EQ(begun, 2);
}

TEST(RunAll, WhoeverIsDoneHelpsTheOthers) {
  // The second call ends at once; the first one needs its thread.
  std::atomic<int> begun = 0;
  std::atomic<bool> second_ended = false;
  run_all(2, 2, [&](std::size_t k, const Team& team) {
    if (k == 1) {
      second_ended = true;
      return;
    }
    while (!second_ended) std::this_thread::yield();
    team.each(2, [&](std::size_t) {
      ++begun;
      while (begun < 2) std::this_thread::yield();
    });
  });
  EXPECT_EQ(begun, 2);
}

TEST(RunAll, PartsThrowWhatTheFirstOfThemThrew) {
  for (const unsigned workers : {1U, 2U, 4U}) {
    std::string thrown;
    run_all(1, workers, [&](std::size_t, const Team& team) {
      try {
        team.each(100, [](std::size_t k) {
          if (k % 10 == 3) throw std::runtime_error(std::to_string(k));
        });
      } catch (const std::runtime_error& e) {
        thrown = e.what();
      }
    });
    EXPECT_EQ(thrown, "3") << workers;
  }
}

TEST(RunAll, RangesAreTheSameForAnyTeam) {
  for (const unsigned workers : {1U, 3U}) {
    std::vector<std::atomic<int>> calls(1000);
    run_all(1, workers, [&](std::size_t, const Team& team) {
      team.each_range(1000, 64, [&](std::size_t first, std::size_t last) {
        EXPECT_EQ(first % 64, 0U);
        for (std::size_t k = first; k < last; ++k) ++calls[k];
      });
    });
    for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(SortByTeam, SortsAsOneDoes) {
  for (const std::size_t count : {0U, 1U, 70'000U, 200'003U}) {
    std::vector<std::uint32_t> list(count);
    std::uint32_t state = 1;
    for (std::uint32_t& item : list) item = state = state * 1664525U + 1013904223U;
    std::vector<std::uint32_t> sorted = list;
    std::sort(sorted.begin(), sorted.end());
    run_all(1, 3, [&](std::size_t, const Team& team) { sort_by_team(list, std::less(), team); });
    EXPECT_TRUE(list == sorted) << count;
  }
}

TEST(WithTeam, WhatTheBodyThrowsReachesTheCaller) {
  for (const unsigned workers : {0U, 1U, 2U}) {
    EXPECT_THROW(with_team(workers, [](const Team&) { throw std::bad_alloc(); }), std::bad_alloc);
    std::size_t seen = 0;
    with_team(workers, [&](const Team& team) { seen = team.workers(); });
    EXPECT_EQ(seen, std::max(workers, 1U));
  }
}

}  // namespace
}  // namespace cover
