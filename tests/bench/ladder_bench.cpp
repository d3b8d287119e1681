// What the steps of the quality method's plan gain and cost on an input, region by region.
//
//   bench_ladder FILE [--effort fast|normal|thorough] [--couplings first|last] [--prefer ...]
//                [--times N] [--without N]...
//
// Any option of cover can be given. A line for each step: regions where it was due and where it
// changed the best mesh; microseconds of CPU for each triangle of the whole result and for each
// region where it was due (the least of N runs, so that other work on the machine counts little);
// mean and 90th percentile of the balanced fault over all regions after it, triangles above 120
// degrees, negative couplings that count. Then what comes before and after the plan.
// `--without N` leaves out step N: what it really gains is the difference.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/option_table.hpp>
#include <cover/read_input.hpp>

#include "method/mesh_one_region.hpp"
#include "quality/plan/candidates.hpp"
#include "quality/plan/plan.hpp"
#include "quality/quality_region.hpp"
#include "region/region_graph.hpp"

namespace {

using namespace cover;

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What is known of one step in one region.
struct Run {
  bool was_due = false;
  bool has_gained = false;
  double seconds = std::numeric_limits<double>::infinity();
  Merit after;
};

struct Totals {
  std::vector<std::vector<Run>> runs;        ///< by step, by region
  std::vector<double> setup, quality, task;  ///< seconds by region
  std::size_t triangles = 0;
};

double timed(double& least, const std::function<void()>& work) {
  const double start = thread_seconds();
  work();
  const double seconds = thread_seconds() - start;
  least = std::min(least, seconds);
  return seconds;
}

void run_steps(std::span<const Step> plan, const RegionBoundary& boundary, const Options& options,
               std::size_t r, Totals& totals) {
  const double start = thread_seconds();
  Candidates candidates(boundary, options, {}, true);
  totals.setup[r] = std::min(totals.setup[r], thread_seconds() - start);
  PlanProgress progress{candidates};
  bool is_over = false;
  for (std::size_t k = 0; k < plan.size(); ++k) {
    Run& run = totals.runs[k][r];
    const Merit before = progress.best.merit;
    if (!is_over) {
      timed(run.seconds, [&] {
        run.was_due = plan[k].is_due(progress);
        if (run.was_due) plan[k].run(progress);
      });
      run.has_gained = k > 0 && candidates.ranking().order().is_better(progress.best.merit, before);
      is_over = is_enough(plan[k], progress);
    } else {
      run.seconds = 0;
    }
    run.after = progress.best.merit;
  }
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

void print(std::span<const Step> plan, const Totals& totals) {
  const std::size_t regions = totals.task.size();
  const double per_triangle = 1e6 / static_cast<double>(totals.triangles);
  fmt::print("{} regions, {} triangles\n", regions, totals.triangles);
  fmt::print("{:<46} {:>6} {:>6} {:>8} {:>9} {:>7} {:>7} {:>6} {:>6}\n", "step", "due", "gained",
             "us/tri", "us/due", "mean", "90 %", ">120", "neg");
  const auto stage = [&](const char* name, const std::vector<double>& seconds) {
    fmt::print("{:<46} {:>6} {:>6} {:>8.2f} {:>9.1f}\n", name, regions, "",
               sum(seconds) * per_triangle, 1e6 * sum(seconds) / static_cast<double>(regions));
  };
  stage("(setup)", totals.setup);
  for (std::size_t k = 0; k < plan.size(); ++k) {
    std::size_t due = 0, gained = 0, far = 0, negative = 0;
    double seconds = 0, mean = 0;
    std::vector<double> faults;
    for (const Run& run : totals.runs[k]) {
      due += run.was_due ? 1 : 0;
      gained += run.has_gained ? 1 : 0;
      seconds += run.seconds;
      far += run.after.far_above;
      negative += run.after.negative;
      faults.push_back(run.after.fault.worst());
      mean += faults.back() / static_cast<double>(regions);
    }
    std::sort(faults.begin(), faults.end());
    fmt::print("{:<46} {:>6} {:>6} {:>8.2f} {:>9.1f} {:>7.4f} {:>7.4f} {:>6} {:>6}\n", plan[k].name,
               due, gained, seconds * per_triangle,
               1e6 * seconds / static_cast<double>(std::max<std::size_t>(due, 1)), mean,
               faults[std::min(regions - 1, regions * 9 / 10)], far, negative);
  }
  stage("(quality_region)", totals.quality);
  stage("(mesh_one_region, limits and checks included)", totals.task);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  OptionReader reader;
  int times = 3;
  std::vector<std::size_t> without;
  for (int k = 2; k + 1 < argc; k += 2) {
    const std::string name = argv[k];
    if (name == "--times") {
      times = std::atoi(argv[k + 1]);
    } else if (name == "--without") {
      without.push_back(static_cast<std::size_t>(std::atoi(argv[k + 1])));
    } else {
      const OptionEntry* const entry =
          find_option(name.substr(std::min<std::size_t>(2, name.size())));
      if (entry == nullptr || !reader.set(*entry, argv[k + 1])) {
        fmt::print(stderr, "{} {}?\n", name, argv[k + 1]);
        return 2;
      }
    }
  }
  const Result<Options> given = reader.result();
  if (!given) {
    fmt::print(stderr, "{}\n", given.error().message);
    return 2;
  }
  Options options = *given;
  options.threads = 1;
  const Result<Input> input = read_input(argv[1]);
  if (!input) {
    fmt::print(stderr, "{}\n", input.error().message);
    return 1;
  }
  const Result<Prepared> prepared = prepare(*input, options);
  if (!prepared) {
    fmt::print(stderr, "{}\n", prepared.error().message);
    return 1;
  }
  const std::vector<RegionBoundary> boundaries = split_regions(prepared->pslg, prepared->table);
  std::vector<Step> plan;
  const std::span<const Step> whole = plan_for(options, false);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    if (std::find(without.begin(), without.end(), k) == without.end()) plan.push_back(whole[k]);
  }
  const std::size_t regions = boundaries.size();
  Totals totals;
  const std::vector<double> none(regions, std::numeric_limits<double>::infinity());
  totals.setup = totals.quality = totals.task = none;
  totals.runs.assign(plan.size(), std::vector<Run>(regions));
  for (int time = 0; time < times; ++time) {
    for (std::size_t r = 0; r < regions; ++r) {
      run_steps(plan, boundaries[r], options, r, totals);
      timed(totals.quality[r], [&] { quality_region(boundaries[r], options, {}); });
      RegionMesh mesh;
      timed(totals.task[r], [&] { mesh = mesh_one_region(boundaries[r], options, {}); });
      if (time == 0) totals.triangles += mesh.triangles.size();
    }
  }
  print(plan, totals);
  return 0;
}
