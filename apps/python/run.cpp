#include "run.hpp"

#include <unistd.h>

#include <algorithm>
#include <thread>
#include <vector>

namespace cover::python {
namespace {

namespace py = pybind11;

/// Longer than a run takes to heed a stop; what cannot be stopped, as a file that is read, does not
/// hold the end of a program up for ever.
constexpr std::chrono::seconds kPatience(5);

using RunState = CurrentRun::State;

/// What belongs to the interpreter; the list is read and written with the GIL.
struct Runs {
  std::vector<std::shared_ptr<RunState>> current;
  std::atomic<bool> ending{false};
  std::thread::id ender;  ///< once `ending`
};

/// Never destroyed: threads look into it to the end.
Runs& runs() {
  static Runs* const all = new Runs;
  return *all;
}

void end_runs() {
  Runs& all = runs();
  all.ender = std::this_thread::get_id();
  all.ending = true;
  const std::vector<std::shared_ptr<RunState>> current = all.current;
  const WithoutGil released;  // a callable may be at work
  for (const auto& run : current) run->stop.request_stop();
  const auto until = std::chrono::steady_clock::now() + kPatience;
  const auto is_over = [](const std::shared_ptr<RunState>& run) {
    return run->done || run->process != getpid();
  };
  while (!std::all_of(current.begin(), current.end(), is_over) &&
         std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

}  // namespace

void stop_runs_at_exit() {
  py::module_::import("atexit").attr("register")(py::cpp_function(&end_runs));
}

void wait_for_exit() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

bool is_ending() {
  const Runs& all = runs();
  return all.ending && all.ender != std::this_thread::get_id();
}

CurrentRun::CurrentRun(const Callables& callables)
    : state_(std::make_shared<State>(callables.source(), static_cast<int>(getpid()))) {
  if (is_ending()) {
    PyEval_SaveThread();
    wait_for_exit();
  }
  runs().current.push_back(state_);
}

CurrentRun::~CurrentRun() {
  auto& current = runs().current;
  current.erase(std::remove(current.begin(), current.end(), state_), current.end());
}

}  // namespace cover::python
