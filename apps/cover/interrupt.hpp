// Ctrl-C as a request to stop.
#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace cover::app {

/// While it lives, SIGINT and SIGTERM ask the run to stop; a second one ends the program at once.
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

 private:
  void wait(const std::stop_token& done);

  sigset_t signals_{};
  std::stop_source source_;
  std::jthread waiter_;
};

}  // namespace cover::app
