#include "interrupt.hpp"

#include <pthread.h>

#include <cstdlib>

#include "exit_code.hpp"

namespace cover::app {

Interrupt::Interrupt() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
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
  while (!done.stop_requested()) {
    sigwait(&signals_, &signal);
    if (!done.stop_requested() && !writing_) std::_Exit(exit_interrupted);
  }
}

}  // namespace cover::app
