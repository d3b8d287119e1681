// Tested by tests/unit/base/faults/machine_memory_test.cpp.
#include "base/faults/machine_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "base/numbers.hpp"

namespace cover {
namespace {

constexpr double kNoLimit = kInfinity;

double physical() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  return pages > 0 && size > 0 ? static_cast<double>(pages) * static_cast<double>(size) : kNoLimit;
}

/// What `ulimit -v` and `ulimit -d` say.
double allowed(decltype(RLIMIT_AS) which) {
  rlimit limit{};
  if (getrlimit(which, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNoLimit;
  return static_cast<double>(limit.rlim_cur);
}

/// A number in a file of the kernel; "max" and files that are not there are no limit.
double number_in(const char* path) {
  double number = 0;
  return std::ifstream(path) >> number && number > 0 ? number : kNoLimit;
}

}  // namespace

double machine_memory() {
  return std::min({physical(), allowed(RLIMIT_AS), allowed(RLIMIT_DATA),
                   number_in("/sys/fs/cgroup/memory.max"),
                   number_in("/sys/fs/cgroup/memory/memory.limit_in_bytes")});
}

}  // namespace cover
