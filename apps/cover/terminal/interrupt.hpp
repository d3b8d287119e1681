// Ctrl-C as a request to stop.
#pragma once

#include <atomic>
#include <csignal>
#include <stop_token>
#include <thread>

namespace cover::app {

/// While it lives, SIGINT and SIGTERM ask the run to stop. Whatever does not heed that within a
/// second is ended with the program, and so it is by a second signal; no file is half written then,
/// since files get their names when they are whole.
///
/// A thread of its own waits for the signals, because a signal handler may not touch a stop_source.
/// REQUIRES: made before any other thread, so that all threads inherit the blocked signals.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
  /// To be called when all files are written: from here on signals change nothing.
  void finish() { finished_ = true; }

 private:
  void wait(const std::stop_token& done);

  sigset_t signals_{};
  std::stop_source source_;
  std::atomic<bool> finished_ = false;
  std::jthread waiter_;
};

}  // namespace cover::app
