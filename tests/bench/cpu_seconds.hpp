// The clock of benchmarks: other work on the machine does not move it.
#pragma once

#include <ctime>

/// CPU seconds of this process, all threads together.
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
