// The disk packing fill from 1e2 to 1e5 boundary vertices: time per disk should stay flat.
#include <benchmark/benchmark.h>

#include "disks/fill_disks.hpp"
#include "support/filling_checks.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

void fill(benchmark::State& state, const RegionBoundary& boundary, bool removes_spare_vertices) {
  const FillTask task = testing::task_of(boundary);
  PackingRecord record;
  for (auto _ : state) {
    const Filling filling =
        make_disk_filler({.removes_spare_vertices = removes_spare_vertices, .record = &record})
            ->fill(task, {});
    benchmark::DoNotOptimize(filling.triangles.data());
    state.counters["vertices_per_vertex"] =
        1 + static_cast<double>(filling.added.size()) / static_cast<double>(task.points.size());
  }
  const auto disks = static_cast<double>(record.disks.size());
  state.counters["disks"] = disks;
  state.counters["attempts"] = record.attempts;
  state.counters["time_per_disk"] = benchmark::Counter(
      disks, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void spiky_star(benchmark::State& state) {
  std::mt19937_64 random(1);
  fill(state,
       testing::boundary_of({testing::random_star(static_cast<int>(state.range(0)), 0.5, random)}),
       state.range(1) != 0);
}
BENCHMARK(spiky_star)
    ->ArgsProduct({{100, 1000, 10'000, 100'000}, {0, 1}})
    ->ArgNames({"vertices", "thin"})
    ->Unit(benchmark::kMillisecond);

void smooth_star(benchmark::State& state) {
  fill(state, testing::boundary_of({testing::smooth_star(static_cast<int>(state.range(0)), 1)}),
       true);
}
BENCHMARK(smooth_star)->RangeMultiplier(10)->Range(100, 100'000)->Unit(benchmark::kMillisecond);

/// A grid of square holes: n * n holes, 4 n n + 4 vertices.
void holes(benchmark::State& state) {
  const auto n = static_cast<int>(state.range(0));
  const double size = 2 * n + 1;
  std::vector<testing::Loop> loops{{{0, 0}, {size, 0}, {size, size}, {0, size}}};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = 2 * i + 1, y = 2 * j + 1;
      loops.push_back({{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}});
    }
  }
  fill(state, testing::boundary_of(loops), true);
}
BENCHMARK(holes)->Arg(5)->Arg(16)->Arg(50)->Arg(158)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cover

BENCHMARK_MAIN();
