#include "progress_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "console.hpp"

namespace cover::app {

ProgressLine::ProgressLine(ShowProgress show)
    : on_(show == ShowProgress::on ||
          (show == ShowProgress::automatic && isatty(STDERR_FILENO) != 0)) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (!drawn_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

void ProgressLine::update(const Progress& progress) {
  if (!on_) return;
  const auto now = Clock::now();
  if (progress.stage != stage_) {
    stage_ = progress.stage;
    stage_start_ = now;
  } else if (now - last_ < std::chrono::milliseconds(100)) {
    return;
  }
  last_ = now;

  std::string line = fmt::format("{:<10}", stage_);
  if (progress.total > 0) {
    constexpr std::size_t kWidth = 30;
    const double part =
        std::min(1.0, static_cast<double>(progress.done) / static_cast<double>(progress.total));
    const auto filled = static_cast<std::size_t>(part * kWidth);
    line += fmt::format(" [{}{}] {:3.0f} %", std::string(filled, '#'),
                        std::string(kWidth - filled, ' '), 100 * part);
    const double seconds = std::chrono::duration<double>(now - stage_start_).count();
    if (progress.done > 0 && seconds > 0.3) {
      const double rate = static_cast<double>(progress.done) / seconds;
      line += fmt::format("  {}/s  {:.0f} s left", grouped(static_cast<std::size_t>(rate)),
                          seconds * (1 - part) / std::max(part, 1e-9));
    }
  }
  std::fputs(("\r\x1b[K" + line).c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace cover::app
