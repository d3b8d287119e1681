#include "tasks/followed_run.hpp"

#include <condition_variable>
#include <mutex>
#include <new>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cover {
namespace {

/// Work that takes until it is stopped.
Status until_stopped(const Callbacks& callbacks) {
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  stopped.wait(lock, callbacks.stop, [] { return false; });
  return Error{ErrorCode::cancelled, "stopped", {}, {}};
}

Status told_and_stopped(const Callbacks& callbacks) {
  callbacks.progress({"cut", 2, 5});
  return until_stopped(callbacks);
}

TEST(FollowedRun, TellsAStepAgainUntilItIsStopped) {
  std::stop_source stop;
  Callbacks asked;
  asked.stop = stop.get_token();
  std::vector<Progress> told;
  asked.progress = [&](const Progress& step) {
    told.push_back(step);
    if (told.size() == 3) stop.request_stop();
  };
  const Status status = followed("run", asked, told_and_stopped);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cancelled);
  ASSERT_EQ(told.size(), 3U);
  for (const Progress& step : told) {
    EXPECT_EQ(step.stage, "cut");
    EXPECT_EQ(step.done, 2U);
    EXPECT_EQ(step.total, 5U);
  }
}

TEST(FollowedRun, TellsNothingBeforeThereIsAStep) {
  std::stop_source stop;
  Callbacks asked;
  asked.stop = stop.get_token();
  stop.request_stop();
  int calls = 0;
  asked.progress = [&](const Progress&) { ++calls; };
  EXPECT_FALSE(followed("run", asked, until_stopped));
  EXPECT_EQ(calls, 0);
}

TEST(FollowedRun, WhatIsThrownStopsTheRunAndReachesTheCaller) {
  for (const std::size_t at : {1U, 2U}) {  // the second time, it is told by another thread
    Callbacks asked;
    std::size_t calls = 0;
    asked.progress = [&](const Progress&) {
      if (++calls == at) throw std::runtime_error("enough");
    };
    EXPECT_THROW((void)followed("run", asked, told_and_stopped), std::runtime_error);
    EXPECT_EQ(calls, at);
  }
}

TEST(FollowedRun, WhatIsThrownIsTakenForNothingElse) {
  Callbacks asked;
  asked.progress = [](const Progress&) { throw std::bad_alloc(); };
  EXPECT_THROW((void)followed("run", asked, told_and_stopped), std::bad_alloc);
  asked.progress = [](const Progress&) { throw 7; };
  EXPECT_THROW((void)followed("run", asked, told_and_stopped), int);
  asked.progress = {};
  asked.packing = [](RegionId, const PackingRecord&) { throw std::runtime_error("enough"); };
  const auto packed = [](const Callbacks& callbacks) {
    callbacks.packing(RegionId{1}, {});
    return until_stopped(callbacks);
  };
  EXPECT_THROW((void)followed("run", asked, packed), std::runtime_error);
}

TEST(FollowedRun, WhatTheRunThrowsIsAnError) {
  const Status failed = followed(
      "run", {}, [](const Callbacks&) -> Status { throw std::logic_error("upside down"); });
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::internal);
  EXPECT_NE(failed.error().message.find("run: upside down"), std::string::npos);
  const Status memory =
      followed("run", {}, [](const Callbacks&) -> Status { throw std::bad_alloc(); });
  EXPECT_EQ(memory.error().code, ErrorCode::out_of_memory);
}

}  // namespace
}  // namespace cover
