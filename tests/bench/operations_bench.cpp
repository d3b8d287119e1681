// What several threads gain in a whole run, counted in operations: the arguments are those of
// `cover`, the run is that of `cover`, with threads as `-j` says, but one thread does all of it and
// notes which parts could have been done at a time. That is then dealt out to P threads as the
// pool of base/run_all does it.
//
// An operation is a basic block of compiled code (operations.cmake): of cover, CGAL, OpenMesh and
// of templates. Not counted: libraries that are linked, clearing and copying of memory, the system.
// Counts are the same in each run and on each machine with the same compiler.
//
// OPERATIONS_PROFILE=FILE: how long stacks take when 32 threads are at work, one stack a line.
#include <execinfo.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/run_all.hpp"

namespace {

using Count = std::uint64_t;

constexpr Count kNever = std::numeric_limits<Count>::max();
constexpr std::array<unsigned, 7> kThreads{1, 2, 4, 8, 16, 32, 64};
constexpr unsigned kProfiled = 32;

// Of the thread that meshes: others wait for signals and draw lines.
thread_local Count blocks = 0;
thread_local Count next_sample = kNever;

}  // namespace

/// Called by each basic block.
extern "C" void __sanitizer_cov_trace_pc();

namespace {

/// Some operations, then parts that may be done at a time, if there are some.
struct Step {
  Count operations = 0;
  std::vector<std::size_t> parts{};  ///< tasks
  bool in_pool = false;              ///< parts are calls of run_all()
};
using Task = std::vector<Step>;

/// Where the run was, at some operation of a task.
struct Sample {
  std::size_t task;
  std::size_t step;
  Count at;  ///< of the step's operations
  std::array<void*, 48> stack;
  int depth;
};

class Recorder {
 public:
  /// Whole runs have some 1e10.
  static constexpr Count kInterval = 500'000;

  Recorder() : tasks_(1) { tasks_[0].emplace_back(); }

  void begin(bool profile) {
    last_ = blocks;
    if (profile) next_sample = blocks + kInterval;
  }
  void end() {
    close();
    next_sample = kNever;
  }

  void sample() {
    next_sample += kInterval;
    Sample& sample = samples_.emplace_back();
    sample.task = now_;
    sample.step = tasks_[now_].size() - 1;
    sample.at = tasks_[now_].back().operations + blocks - last_;
    sample.depth = backtrace(sample.stack.data(), static_cast<int>(sample.stack.size()));
  }

  void fork(std::size_t count, bool in_pool, const std::function<void(std::size_t)>& run) {
    close();
    const std::size_t parent = now_;
    std::vector<std::size_t> parts;
    for (std::size_t k = 0; k < count; ++k) {
      begin_task(parts);
      run(k);
      close();
    }
    end_tasks(parent, std::move(parts), in_pool);
  }

  [[nodiscard]] const std::vector<Task>& tasks() const { return tasks_; }
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

 private:
  /// No samples while the list of tasks changes, which has blocks, too.
  class NoSamples {
   public:
    NoSamples() = default;
    NoSamples(const NoSamples&) = delete;
    NoSamples& operator=(const NoSamples&) = delete;
    ~NoSamples() { next_sample = next_; }

   private:
    Count next_ = std::exchange(next_sample, kNever);
  };

  void begin_task(std::vector<std::size_t>& parts) {
    const NoSamples none;
    now_ = tasks_.size();
    parts.push_back(now_);
    tasks_.emplace_back().emplace_back();
    last_ = blocks;
  }
  void end_tasks(std::size_t parent, std::vector<std::size_t>&& parts, bool in_pool) {
    const NoSamples none;
    now_ = parent;
    tasks_[now_].back().parts = std::move(parts);
    tasks_[now_].back().in_pool = in_pool;
    tasks_[now_].emplace_back();
    last_ = blocks;
  }

  void close() {
    tasks_[now_].back().operations += blocks - last_;
    last_ = blocks;
  }

  std::vector<Task> tasks_;
  std::vector<Sample> samples_;
  std::size_t now_ = 0;
  Count last_ = 0;
};

Recorder recorder;

class RecordingCrew final : public cover::Crew {
 public:
  explicit RecordingCrew(unsigned workers) : workers_(workers) {}
  [[nodiscard]] unsigned workers() const override { return workers_; }
  void each(std::size_t count, const std::function<void(std::size_t)>& run) override {
    recorder.fork(count, false, run);
  }

 private:
  unsigned workers_;
};

/// Tasks dealt out as base/run_all does it: the newest parts first, then calls; whoever divides its
/// work takes its own parts, and then waits.
class Simulation {
 public:
  Simulation(const std::vector<Task>& tasks, unsigned threads)
      : tasks_(tasks), frames_(threads), begun_(tasks.size()) {}

  /// Operations from the beginning to the end.
  Count run() {
    push_task(0, 0, kNone);
    wake(0, 0);
    while (!events_.empty()) {
      const auto [time, thread] = events_.top();
      events_.pop();
      now_ = time;
      go_on(thread);
    }
    return now_;
  }

  /// When steps of a task began.
  [[nodiscard]] const std::vector<std::vector<Count>>& begun() const { return begun_; }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  struct Parts {
    const std::vector<std::size_t>* tasks;
    std::size_t next = 0, working = 0;
    std::size_t owner;
    bool waits = false;
  };
  struct Frame {
    std::size_t task;
    std::size_t part_of;
    std::size_t step = 0;
    bool computed = false;
    std::size_t own_parts = kNone;
  };

  void wake(std::size_t thread, Count time) { events_.emplace(time, thread); }

  void push_task(std::size_t thread, std::size_t task, std::size_t part_of) {
    frames_[thread].push_back({task, part_of});
    begun_[task].clear();
  }

  bool take(std::size_t thread, std::size_t parts) {
    Parts& from = parts_[parts];
    if (from.next == from.tasks->size()) return false;
    const std::size_t task = (*from.tasks)[from.next++];
    if (from.next == from.tasks->size()) std::erase(open_, parts);
    ++from.working;
    push_task(thread, task, parts);
    return true;
  }

  void go_on(std::size_t thread) {
    auto& frames = frames_[thread];
    for (;;) {
      if (frames.empty()) {
        if (open_.empty()) {
          idle_.push_back(thread);
          return;
        }
        take(thread, open_.back());
      }
      Frame& frame = frames.back();
      const Task& task = tasks_[frame.task];
      if (frame.step == task.size()) {
        const std::size_t part_of = frame.part_of;
        frames.pop_back();
        if (part_of == kNone) return;  // the whole run
        Parts& parts = parts_[part_of];
        if (--parts.working == 0 && parts.waits) {
          parts.waits = false;
          wake(parts.owner, now_);
        }
        continue;
      }
      const Step& step = task[frame.step];
      if (!frame.computed) {
        begun_[frame.task].push_back(now_);
        frame.computed = true;
        if (step.operations > 0) {
          wake(thread, now_ + step.operations);
          return;
        }
      }
      if (step.parts.empty()) {
        ++frame.step;
        frame.computed = false;
        continue;
      }
      if (frame.own_parts == kNone) {
        frame.own_parts = parts_.size();
        parts_.push_back({&step.parts, 0, 0, thread});
        // Calls wait until nobody has parts.
        open_.insert(step.in_pool ? open_.begin() : open_.end(), frame.own_parts);
        for (const std::size_t other : idle_) wake(other, now_);
        idle_.clear();
        if (!woken_) {
          woken_ = true;
          for (std::size_t other = 1; other < frames_.size(); ++other) wake(other, now_);
        }
      }
      if (take(thread, frame.own_parts)) continue;
      Parts& parts = parts_[frame.own_parts];
      if (parts.working > 0) {
        if (step.in_pool && !open_.empty()) {  // calls: the caller helps, too
          take(thread, open_.back());
          continue;
        }
        parts.waits = true;
        return;
      }
      frame.own_parts = kNone;
      ++frame.step;
      frame.computed = false;
    }
  }

  const std::vector<Task>& tasks_;
  std::vector<std::vector<Frame>> frames_;
  std::vector<std::vector<Count>> begun_;
  std::vector<Parts> parts_;
  std::vector<std::size_t> open_, idle_;
  bool woken_ = false;
  std::priority_queue<std::pair<Count, std::size_t>, std::vector<std::pair<Count, std::size_t>>,
                      std::greater<>>
      events_;
  Count now_ = 0;
};

Count work_of(const std::vector<Task>& tasks) {
  Count sum = 0;
  for (const Task& task : tasks)
    for (const Step& step : task) sum += step.operations;
  return sum;
}

/// As long as the longest chain of operations that need each other.
Count span_of(const std::vector<Task>& tasks) {
  std::vector<Count> spans(tasks.size());
  for (std::size_t task = tasks.size(); task-- > 0;) {  // parts come after whoever has them
    for (const Step& step : tasks[task]) {
      Count longest = 0;
      for (const std::size_t part : step.parts) longest = std::max(longest, spans[part]);
      spans[task] += step.operations + longest;
    }
  }
  return spans[0];
}

/// Operations that are in no part.
Count serial_of(const std::vector<Task>& tasks) {
  std::vector<char> serial(tasks.size());
  Count sum = 0;
  serial[0] = 1;
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    if (serial[task] == 0) continue;
    for (const Step& step : tasks[task]) {
      sum += step.operations;
      if (step.parts.size() == 1) serial[step.parts[0]] = 1;
    }
  }
  return sum;
}

/// Each sample stands for its operations' share of the time in which as many threads are busy.
void write_profile(const Simulation& simulation, const char* name) {
  const auto& tasks = recorder.tasks();
  std::vector<std::pair<Count, int>> changes;
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    for (std::size_t k = 0; k < simulation.begun()[task].size(); ++k) {
      if (tasks[task][k].operations == 0) continue;
      const Count begin = simulation.begun()[task][k];
      changes.emplace_back(begin, 1);
      changes.emplace_back(begin + tasks[task][k].operations, -1);
    }
  }
  std::sort(changes.begin(), changes.end());
  std::vector<int> busy;
  for (int sum = 0; const auto& change : changes) busy.push_back(sum += change.second);
  std::FILE* file = std::fopen(name, "w");
  if (file == nullptr) throw std::runtime_error("cannot write the profile");
  for (const Sample& sample : recorder.samples()) {
    const Count time = simulation.begun()[sample.task].at(sample.step) + sample.at;
    const auto after = std::upper_bound(changes.begin(), changes.end(), std::pair(time - 1, 2));
    const auto at = static_cast<std::size_t>(after - changes.begin());
    const int threads = at == 0 ? 1 : std::max(1, busy[at - 1]);
    std::fprintf(file, "%.6f %d", 1.0 / threads, threads);
    for (int k = 0; k < sample.depth; ++k)
      std::fprintf(file, " %p", sample.stack[static_cast<std::size_t>(k)]);
    std::fputc('\n', file);
  }
  std::fclose(file);
}

void print_counts() {
  const auto& tasks = recorder.tasks();
  const Count work = work_of(tasks);
  if (work == 0) {
    std::fputs("No basic blocks were counted: see operations.cmake.\n", stderr);
    return;
  }
  const auto of_work = [&](Count part) {
    return static_cast<double>(part) / static_cast<double>(work);
  };
  const Count span = span_of(tasks);
  const Count serial = serial_of(tasks);
  std::fprintf(stderr, "operations %llu, in no part %.2f %%, span %.2f %% (1/%.1f), tasks %zu\n",
               static_cast<unsigned long long>(work), 100 * of_work(serial), 100 * of_work(span),
               1 / of_work(span), tasks.size());
  for (const unsigned threads : kThreads) {
    Simulation simulation(tasks, threads);
    const Count time = simulation.run();
    std::fprintf(stderr, "threads %2u: %.2f times, Amdahl %.2f\n", threads, 1 / of_work(time),
                 1 / (of_work(serial) + (1 - of_work(serial)) / threads));
    if (threads == kProfiled && std::getenv("OPERATIONS_PROFILE") != nullptr)
      write_profile(simulation, std::getenv("OPERATIONS_PROFILE"));
  }
}

}  // namespace

extern "C" void __sanitizer_cov_trace_pc() {
  if (++blocks >= next_sample) recorder.sample();
}

namespace cover {

unsigned worker_count(unsigned threads) { return threads != 0 ? threads : 2; }

void run_all(std::size_t count, unsigned workers,
             const std::function<void(std::size_t, const Team&)>& run) {
  if (workers < 2) {
    for (std::size_t k = 0; k < count; ++k) run(k, Team());
  } else {
    RecordingCrew crew(workers);
    recorder.fork(count, true, [&](std::size_t k) { run(k, Team(crew)); });
  }
}

void run_all(std::size_t count, unsigned workers, const std::function<void(std::size_t)>& run) {
  run_all(count, workers, [&run](std::size_t k, const Team&) { run(k); });
}

}  // namespace cover

int cover_main(int argc, char** argv);

int main(int argc, char** argv) {
  recorder.begin(std::getenv("OPERATIONS_PROFILE") != nullptr);
  const int code = cover_main(argc, argv);
  recorder.end();
  print_counts();
  return code;
}
