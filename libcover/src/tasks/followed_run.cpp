// Tested by tests/unit/tasks/followed_run_test.cpp.
#include "tasks/followed_run.hpp"

#include <chrono>
#include <new>
#include <system_error>

namespace cover {
namespace {

constexpr std::chrono::milliseconds kToldAgainAfter{200};

}  // namespace

FollowedRun::FollowedRun(const Callbacks& asked, std::exception_ptr& thrown)
    : asked_(asked),
      callbacks_(asked),
      on_stop_(asked.stop, [this] { stop_.request_stop(); }),
      thrown_(thrown) {
  callbacks_.stop = stop_.get_token();
  if (asked.packing)
    callbacks_.packing = [this](RegionId region, const PackingRecord& packing) {
      const std::lock_guard lock(mutex_);
      call([&] { asked_.packing(region, packing); });
    };
  if (!asked.progress) return;
  callbacks_.progress = [this](const Progress& step) { tell(step); };
  try {
    again_ = std::jthread([this](const std::stop_token& end) { tell_again(end); });
  } catch (const std::system_error&) {  // no thread to be had: steps are told once
  } catch (const std::bad_alloc&) {
  }
}

template <class Function>
void FollowedRun::call(const Function& function) {
  if (thrown_) return;
  try {
    function();
  } catch (...) {
    thrown_ = std::current_exception();
    stop_.request_stop();
  }
}

void FollowedRun::tell(const Progress& step) {
  const std::lock_guard lock(mutex_);
  last_ = step;
  was_told_ = true;
  call([&] { asked_.progress(step); });
}

void FollowedRun::tell_again(const std::stop_token& end) {
  std::unique_lock lock(mutex_);
  while (!wakes_.wait_for(lock, end, kToldAgainAfter, [&] { return end.stop_requested(); })) {
    if (last_ && !was_told_ && !stop_.stop_requested()) call([&] { asked_.progress(*last_); });
    was_told_ = false;
  }
}

}  // namespace cover
