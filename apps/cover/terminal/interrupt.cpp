#include "terminal/interrupt.hpp"

#include <pthread.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <system_error>

#include "commands/exit_code.hpp"

namespace cover::app {
namespace {

namespace fs = std::filesystem;

/// Removes the temporary files and folders that this process has open. Without /proc they stay
/// until their files are written again.
void remove_open_temporary_files() {
  std::error_code ignored;
  for (fs::directory_iterator entry("/proc/self/fd", ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    std::error_code gone;
    const fs::path path = fs::read_symlink(entry->path(), gone);
    const std::string name = path.filename();
    if (gone || !name.starts_with('.')) continue;
    if (name.ends_with(".tmp")) fs::remove(path, gone);
    // What write_to() and a page's picture pass through: ScratchFolder holds them open.
    if (name.starts_with(".cover-") && fs::is_directory(path, gone)) fs::remove_all(path, gone);
  }
}

}  // namespace

Interrupt::Interrupt() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGTERM);
  // A shell's job in the background and nohup ignore these, and blocked signals are not ignored.
  for (const int signal : {SIGINT, SIGHUP}) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN)
      sigaddset(&signals_, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  waiter_ = std::jthread([this](std::stop_token done) { wait(done); });
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  pthread_kill(waiter_.native_handle(), SIGTERM);  // wakes sigwait
}

void Interrupt::wait(const std::stop_token& done) {
  int signal = 0;
  sigwait(&signals_, &signal);
  if (done.stop_requested()) return;
  source_.request_stop();
  constexpr timespec kPatience{0, 900'000'000};
  sigtimedwait(&signals_, nullptr, &kPatience);
  if (done.stop_requested() || finished_) return;
  remove_open_temporary_files();
  std::fputs("cover: error: interrupted\n", stderr);
  std::_Exit(exit_interrupted);
}

}  // namespace cover::app
