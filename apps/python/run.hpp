// Work on another thread, without the lock of the interpreter (GIL), while the calling thread looks
// for signals, so that Ctrl-C stops it and other threads of Python go on.
//
// Daemon threads are at work when the interpreter ends. It lets no other thread in then: Python
// (before 3.14) ends a thread that comes for the lock, by an unwinding that nothing may stop, and
// C++ aborts where that meets a destructor or a handler of everything. A little later the process
// takes down what the library works with. So all runs are stopped before, by Python's atexit, and
// whoever comes for the lock after that waits for the end of the process, as Python itself has it
// since 3.14.
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

#include <pybind11/pybind11.h>
#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

#include "raise.hpp"

namespace cover::python {

/// Has all runs stopped when the interpreter ends.
void stop_runs_at_exit();

/// Never returns.
[[noreturn]] void wait_for_exit();
/// Whether the interpreter ends, on another thread than this.
bool is_ending();

/// What `f` returns or throws; where Python ends the thread in it, waits for the end of the
/// process.
template <class F>
auto unless_ended(F f) -> decltype(f()) {
#ifdef __GLIBCXX__
  try {
    return f();
  } catch (const abi::__forced_unwind&) {
    wait_for_exit();
  }
#else
  return f();
#endif
}

/// Gives up the lock while it lives.
class WithoutGil {
 public:
  WithoutGil() : state_(PyEval_SaveThread()) {}
  ~WithoutGil() {
    if (is_ending()) wait_for_exit();
    unless_ended([this] { PyEval_RestoreThread(state_); });
  }
  WithoutGil(const WithoutGil&) = delete;
  WithoutGil& operator=(const WithoutGil&) = delete;

 private:
  PyThreadState* state_;
};

/// Has the lock while it lives, on any thread.
class WithGil {
 public:
  WithGil() {
    unless_ended([this] { gil_.emplace(); });
  }
  WithGil(const WithGil&) = delete;
  WithGil& operator=(const WithGil&) = delete;

 private:
  std::optional<pybind11::gil_scoped_acquire> gil_;
};

/// The callables of a caller: whatever one of them raises stops the run. They are called from other
/// threads, with the GIL; what is here is written with it, too.
class Callables {
 public:
  /// Calls `use` with the GIL; `otherwise` where it raises, and once the run is to stop.
  template <class Value, class Use>
  Value call(Use use, Value otherwise) {
    if (stop_.stop_requested()) return otherwise;  // soon, whatever is asked for until that is seen
    const WithGil gil;
    if (raised_) return otherwise;
    return unless_ended([&] { return called(use, otherwise); });
  }
  void request_stop() { stop_.request_stop(); }
  [[nodiscard]] const std::stop_source& source() const { return stop_; }
  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
  void rethrow() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  template <class Value, class Use>
  Value called(Use& use, Value otherwise) {
    try {
      return use();
#ifdef __GLIBCXX__
    } catch (const abi::__forced_unwind&) {
      throw;
#endif
    } catch (...) {
      raised_ = std::current_exception();
      stop_.request_stop();
      return otherwise;
    }
  }

  std::stop_source stop_;
  std::exception_ptr raised_;
};

/// A run that the end of the interpreter has to stop. It begins and ends with the GIL.
class CurrentRun {
 public:
  /// Waits for the end of the process where it has begun.
  explicit CurrentRun(const Callables& callables);
  ~CurrentRun();
  CurrentRun(const CurrentRun&) = delete;
  CurrentRun& operator=(const CurrentRun&) = delete;

  struct State {
    State(std::stop_source source, int pid) : stop(std::move(source)), process(pid) {}
    std::stop_source stop;
    int process;  ///< a forked one has the runs of its parent, but not their threads
    std::atomic<bool> done{false};
  };
  /// The work is over.
  void finish() { state_->done = true; }

 private:
  std::shared_ptr<State> state_;
};

/// The value that `work()` returns on another thread. A signal whose handler raises asks
/// `callables` to stop, and what it raised comes out.
template <class Work>
auto run(Callables& callables, Work work) {
  bool interrupted = false;
  CurrentRun current(callables);
  auto result = [&] {
    const WithoutGil released;
    auto future = std::async(std::launch::async, [&] {
      struct AtTheEnd {
        CurrentRun& run;
        ~AtTheEnd() { run.finish(); }
      } const at_the_end{current};
      return work();
    });
    while (future.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout) {
      const WithGil gil;
      if (interrupted || PyErr_CheckSignals() == 0) continue;
      interrupted = true;
      callables.request_stop();
    }
    return future.get();
  }();
  callables.rethrow();
  if (interrupted) throw pybind11::error_already_set();  // PyErr_CheckSignals has set it
  if (!result) raise(result.error());
  return std::move(result).value();
}

}  // namespace cover::python
