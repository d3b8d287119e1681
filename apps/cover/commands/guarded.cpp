#include "commands/guarded.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <spdlog/common.h>

#include "commands/exit_code.hpp"
#include "memory/page_pool.hpp"

namespace cover::app {
namespace {

/// Large arrays go to a pool of pages, so that each gives way to others when it is freed. malloc
/// would put ever larger ones among the small ones, where what is freed stays. What it has for
/// others comes again and again: as much of it is kept at the end of the heap, and asked for at a
/// time, as saves two of three page faults.
void keep_apart_large_arrays() {
  pool_large_arrays();
#ifdef __GLIBC__
  constexpr int kMegabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 8 * kMegabyte);
  mallopt(M_TRIM_THRESHOLD, 32 * kMegabyte);
  mallopt(M_TOP_PAD, 8 * kMegabyte);
#endif
}

/// By stdio, which throws nothing and needs no memory: nobody may be there to read it.
void tell_error(std::string_view program, const char* what, const char* more = "") {
  std::fprintf(stderr, "%.*s: error: %s%s\n", static_cast<int>(program.size()), program.data(),
               what, more);
}

int run(std::string_view program, const std::function<int()>& command) {
  try {
    return command();
  } catch (const spdlog::spdlog_ex& error) {  // the file of --log
    tell_error(program, error.what());
    return exit_files;
  } catch (const std::bad_alloc&) {
    tell_error(program, "out of memory");
    return exit_memory;
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) return exit_ok;  // of fmt; guarded() tells it
    // No thread, for which there must be a stack.
    tell_error(program, "the system has no more threads or memory: ", error.what());
    return exit_memory;
  } catch (const std::exception& error) {
    tell_error(program, error.what(), "; this is an error in cover, please report it");
  }
  return exit_internal;
}

}  // namespace

int guarded(std::string_view program, const std::function<int()>& command) {
  keep_apart_large_arrays();
  // A file longer than `ulimit -f` is then an error of the write, which is told and cleaned up.
  std::signal(SIGXFSZ, SIG_IGN);
  const int code = run(program, command);
  // What was printed may wait in a buffer until here, and a full disk then loses it.
  errno = 0;
  const bool lost = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  if (!lost || code == exit_files) return code;
  const std::string why = errno != 0 ? ": " + std::generic_category().message(errno) : "";
  tell_error(program, "cannot write to standard output", why.c_str());
  return code == exit_ok ? exit_files : code;
}

}  // namespace cover::app
