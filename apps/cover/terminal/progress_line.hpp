// A line on stderr that shows how far a run is.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include <cover/progress.hpp>

namespace cover::app {

/// When progress is shown.
enum class ShowProgress { automatic, on, off };

/// The text of the line: `stage  [####      ] 41 %  12,300/s  3 s left`, or the seconds that the
/// stage has taken where no rate is known yet.
std::string progress_text(const Progress& progress, double seconds);

/// Draws the line several times a second, also while the run has nothing to tell, and wipes it when
/// destroyed. `automatic` draws only where stderr is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(ShowProgress show);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void update(const Progress& progress);
  /// Wipes the line and draws no more, so that something else can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  /// REQUIRES: mutex_ is held
  void draw();
  void tick(const std::stop_token& stop);

  bool is_on_ = false;
  std::mutex mutex_;  ///< of all that follows
  bool drawn_ = false;
  std::string stage_;
  Progress progress_;
  Clock::time_point stage_start_;
  Clock::time_point last_;
  std::condition_variable_any wakes_;
  std::jthread ticker_;  ///< none where none was to be had
};

}  // namespace cover::app
