#include "terminal/progress_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

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
    ticker_ = std::jthread([this](const std::stop_token& stop) { tick(stop); });
  }
}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (!ticker_.joinable()) return;
  ticker_.request_stop();
  ticker_.join();
  if (!drawn_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
}

void ProgressLine::update(const Progress& progress) {
  if (!ticker_.joinable()) return;
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
  std::fputs(("\r\x1b[K" + progress_text(progress_, seconds)).c_str(), stderr);
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
