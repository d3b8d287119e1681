#include "terminal/progress_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <new>
#include <system_error>

#include <fmt/core.h>

#include "terminal/console.hpp"

namespace cover::app {
namespace {

constexpr std::chrono::milliseconds kPause{100};  ///< between two lines

std::string duration(double seconds) {
  return seconds < 120 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

}  // namespace

std::string progress_text(const Progress& progress, double seconds) {
  std::string line = fmt::format("{:<10}", progress.stage);
  const double part =
      progress.total == 0
          ? 0
          : std::min(1.0, static_cast<double>(progress.done) / static_cast<double>(progress.total));
  if (progress.total > 0) {
    constexpr std::size_t kWidth = 30;
    const auto filled = static_cast<std::size_t>(part * kWidth);
    line += fmt::format(" [{}{}] {:3.0f} %", std::string(filled, '#'),
                        std::string(kWidth - filled, ' '), 100 * part);
  }
  if (part > 0 && seconds > 0.3) {
    const double rate = static_cast<double>(progress.done) / seconds;
    line += fmt::format("  {}/s  {} left", grouped(static_cast<std::size_t>(rate)),
                        duration(seconds * (1 - part) / part));
  } else if (seconds >= 1) {
    line += "  " + duration(seconds);
  }
  return line;
}

ProgressLine::ProgressLine(ShowProgress show) {
  if (show == ShowProgress::on || (show == ShowProgress::automatic && isatty(STDERR_FILENO) != 0)) {
    is_on_ = true;
    try {
      ticker_ = std::jthread([this](const std::stop_token& stop) { tick(stop); });
    } catch (const std::system_error&) {  // no thread to be had: drawn where something is told
    } catch (const std::bad_alloc&) {
    }
  }
}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (!is_on_) return;
  is_on_ = false;
  ticker_ = {};
  if (!drawn_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
}

void ProgressLine::update(const Progress& progress) {
  if (!is_on_) return;
  const std::lock_guard lock(mutex_);
  const bool begins = progress.stage != stage_;
  if (begins) {
    stage_ = progress.stage;
    stage_start_ = Clock::now();
  }
  progress_ = progress;
  progress_.stage = stage_;
  if (begins || Clock::now() - last_ > kPause) draw();
}

void ProgressLine::draw() {
  last_ = Clock::now();
  const double seconds = std::chrono::duration<double>(last_ - stage_start_).count();
  try {
    std::fputs(("\r\x1b[K" + progress_text(progress_, seconds)).c_str(), stderr);
  } catch (const std::bad_alloc&) {  // the run decides what becomes of that
    return;
  }
  std::fflush(stderr);
  drawn_ = true;
}

void ProgressLine::tick(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    wakes_.wait_for(lock, stop, 5 * kPause, [] { return false; });
    if (!stop.stop_requested() && !stage_.empty() && Clock::now() - last_ > kPause) draw();
  }
}

}  // namespace cover::app
