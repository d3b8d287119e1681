// Functions of a program come before those of its shared libraries, so that these here are what the
// program, libcover and the C++ library call; the system's own are asked for by dlsym.
#include "failing_calls.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstddef>

namespace cover::testing {
namespace {

struct Plan {
  bool is_on = false;
  int calls = 0;
  int at = 0;
  int error = 0;
};
Plan plan;

/// Whether this call is to fail, with errno set. Does not return where the process is to end.
bool is_to_fail() {
  if (!plan.is_on || ++plan.calls != plan.at) return false;
  if (plan.error == 0) _exit(kKilled);
  errno = plan.error;
  return true;
}

template <class Function>
Function* system_function(Function* /*ours*/, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

void fail_call(int at, int error) { plan = {true, 0, at, error}; }

int end_of_failures() {
  plan.is_on = false;
  return plan.calls;
}

}  // namespace cover::testing

using cover::testing::is_to_fail;
using cover::testing::plan;
using cover::testing::system_function;

extern "C" {

int open(const char* path, int flags, ...) {
  static auto* const real = system_function(&open, "open");
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0) {
    va_list more;
    va_start(more, flags);
    mode = va_arg(more, mode_t);
    va_end(more);
  }
  const bool writes = (flags & O_ACCMODE) != O_RDONLY || (flags & O_DIRECTORY) != 0;
  return writes && is_to_fail() ? -1 : real(path, flags, mode);
}

ssize_t write(int file, const void* bytes, std::size_t size) {
  static auto* const real = system_function(&write, "write");
  if (plan.is_on && plan.error == 0 && plan.calls + 1 == plan.at)
    (void)!real(file, bytes, size / 2);
  return is_to_fail() ? -1 : real(file, bytes, size);
}

int fsync(int file) {
  static auto* const real = system_function(&fsync, "fsync");
  return is_to_fail() ? -1 : plan.is_on ? 0 : real(file);
}

int syncfs(int file) {
  static auto* const real = system_function(&syncfs, "syncfs");
  return is_to_fail() ? -1 : plan.is_on ? 0 : real(file);
}

int rename(const char* from, const char* to) {
  static auto* const real = system_function(&rename, "rename");
  return is_to_fail() ? -1 : real(from, to);
}

int mkdir(const char* path, mode_t mode) {
  static auto* const real = system_function(&mkdir, "mkdir");
  return is_to_fail() ? -1 : real(path, mode);
}

int unlink(const char* path) {
  static auto* const real = system_function(&unlink, "unlink");
  return is_to_fail() ? -1 : real(path);
}

int fchmod(int file, mode_t mode) {
  static auto* const real = system_function(&fchmod, "fchmod");
  return is_to_fail() ? -1 : real(file, mode);
}

}  // extern "C"
