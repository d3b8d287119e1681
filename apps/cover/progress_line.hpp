// A line on stderr that shows how far a run is.
#pragma once

#include <chrono>
#include <string>

#include <cover/progress.hpp>

namespace cover::app {

/// When progress is shown.
enum class ShowProgress { automatic, on, off };

/// Draws `stage  [####      ] 41 %  12,300/s  3 s left`, at most ten times a second, and wipes it
/// when destroyed. `automatic` draws only where stderr is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(ShowProgress show);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void update(const Progress& progress);
  /// Wipes the line, so that something else can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool on_ = false;
  bool drawn_ = false;
  std::string stage_;
  Clock::time_point stage_start_;
  Clock::time_point last_;
};

}  // namespace cover::app
