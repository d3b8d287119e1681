// What several threads gain inside one region, counted on one: the parts that a team would share
// are run one after the other, each with its CPU time, and dealt out to P threads in the order in
// which the pool deals them, the next part to the thread that is free first. So the figures hold on
// a machine that is busy, or has two cores. Memory that threads share is not in them.
//
// Counters: work     CPU seconds of the meshing stage
//           span     the same with as many threads as there are parts
//           mesh_P   speed-up of the meshing stage for P threads
//           all_P    of the whole run, the other stages as they are
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>

#include "base/team.hpp"
#include "clean/pslg.hpp"
#include "cpu_seconds.hpp"
#include "method/mesh_one_region.hpp"
#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"

namespace {

using namespace cover;

constexpr std::array<std::size_t, 4> kThreads{2, 8, 32, 100'000};
using Seconds = std::array<double, kThreads.size()>;

/// Runs parts one after the other and keeps what as many threads would have saved.
class CountingCrew final : public Crew {
 public:
  [[nodiscard]] unsigned workers() const override { return 2; }

  void each(std::size_t count, const std::function<void(std::size_t)>& run) override {
    const Seconds saved_before = saved_;
    const double start = cpu_seconds();
    std::vector<Seconds> parts(count);
    for (std::size_t k = 0; k < count; ++k) {
      const Seconds saved = saved_;
      const double begin = cpu_seconds();
      run(k);
      const double seconds = cpu_seconds() - begin;
      for (std::size_t p = 0; p < kThreads.size(); ++p)
        parts[k][p] = seconds - (saved_[p] - saved[p]);
    }
    const double all = cpu_seconds() - start;
    for (std::size_t p = 0; p < kThreads.size(); ++p)
      saved_[p] = saved_before[p] + all - length(parts, p);
  }

  [[nodiscard]] const Seconds& saved() const { return saved_; }

 private:
  /// How long the parts take, each begun by the thread that is free first.
  static double length(const std::vector<Seconds>& parts, std::size_t p) {
    std::vector<double> free_at(std::min(kThreads[p], parts.size()), 0.0);
    for (const Seconds& part : parts) *std::min_element(free_at.begin(), free_at.end()) += part[p];
    return *std::max_element(free_at.begin(), free_at.end());
  }

  Seconds saved_{};
};

void count_threads(benchmark::State& state, const Input& input, Method method) {
  Options options;
  options.threads = 1;
  options.method = method;
  Report report;
  const auto pslg = make_pslg(input, options, report);
  if (!pslg) throw std::runtime_error(pslg.error().message);
  const auto table = build_region_table(*pslg, options, report.notes);
  if (!table) throw std::runtime_error(table.error().message);
  const std::vector<RegionBoundary> boundaries = split_regions(*pslg, *table);
  for (auto _ : state) {
    CountingCrew crew;
    const double start = cpu_seconds();
    const RegionMesh mesh = mesh_one_region(boundaries.at(0), options, {}, Team(crew));
    const double work = cpu_seconds() - start;
    const double start_of_all = cpu_seconds();
    const auto output = cover_mesh(input, options);
    const double all = cpu_seconds() - start_of_all;
    if (!output) throw std::runtime_error(output.error().message);
    double mesh_stage = 0;
    for (const StageTime& time : output->report.times) {
      if (time.stage == "mesh") mesh_stage = time.seconds;
    }
    double clock = 0;
    for (const StageTime& time : output->report.times) clock += time.seconds;
    const double others = all * (1 - mesh_stage / clock);
    state.SetIterationTime(work);
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
    state.counters["work"] = work;
    state.counters["span"] = work - crew.saved().back();
    for (std::size_t p = 0; p + 1 < kThreads.size(); ++p) {
      const std::string threads = std::to_string(kThreads[p]);
      const double left = work - crew.saved()[p];
      state.counters["mesh_" + threads] = work / left;
      state.counters["all_" + threads] = (others + work) / (others + left);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (const int n : {100'000, 1'000'000}) {
    for (const auto method : {Method::quality, Method::almond}) {
      const std::string name = method == Method::quality ? "quality" : "almond";
      benchmark::RegisterBenchmark(
          (name + "/smooth_star/" + std::to_string(n)).c_str(),
          [=](benchmark::State& state) {
            count_threads(state, testing::input_of(testing::smooth_star(n, 1)), method);
          })
          ->UseManualTime()
          ->Iterations(1)
          ->Unit(benchmark::kSecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
