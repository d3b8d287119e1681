// How long the stages took, for the report. No result depends on it.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <cover/report.hpp>

namespace cover {

/// Measures wall-clock time from its making, or from the last stage that it noted.
class StageClock {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// Appends the time since the last stage to `times`.
  void note(std::string stage, std::vector<StageTime>& times) {
    times.push_back({std::move(stage), seconds()});
    start_ = std::chrono::steady_clock::now();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace cover
