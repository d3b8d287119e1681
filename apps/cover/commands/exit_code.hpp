// The exit codes of the program; they are kept for good.
#pragma once

#include <cover/error.hpp>

namespace cover::app {

enum ExitCode : int {
  exit_ok = 0,
  exit_internal = 1,    ///< a broken promise inside; please report
  exit_usage = 2,       ///< options or configuration
  exit_geometry = 3,    ///< the input is not usable geometry
  exit_incomplete = 4,  ///< a region misses the proven bound; nothing was written
  exit_files = 5,       ///< reading or writing
  exit_unmet = 6,       ///< --require or `check` failed
  exit_memory = 7,      ///< less memory than the run needs
  exit_interrupted = 130,
};

/// The exit code that an error of the library ends the program with.
constexpr ExitCode exit_code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::cancelled:
      return exit_interrupted;
    case ErrorCode::meshing_incomplete:
      return exit_incomplete;
    case ErrorCode::requirement_not_met:
      return exit_unmet;
    case ErrorCode::out_of_memory:
      return exit_memory;
    default:
      break;
  }
  const int hundreds = static_cast<int>(code) / 100;
  return hundreds == 1   ? exit_geometry
         : hundreds == 2 ? exit_files
         : hundreds == 4 ? exit_usage
                         : exit_internal;
}

}  // namespace cover::app
