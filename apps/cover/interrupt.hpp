// Ctrl-C as a request to stop.
#pragma once

#include <atomic>
#include <csignal>
#include <stop_token>
#include <thread>

namespace cover::app {

/// While it lives, SIGINT and SIGTERM ask the run to stop; a second one ends the program at once,
/// but never in the middle of writing files, so that no half file is left.
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
  /// From here on a second signal changes nothing.
  void start_writing() { writing_ = true; }

 private:
  void wait(const std::stop_token& done);

  sigset_t signals_{};
  std::stop_source source_;
  std::atomic<bool> writing_ = false;
  std::jthread waiter_;
};

}  // namespace cover::app
