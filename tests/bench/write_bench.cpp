// Writing a million triangles, per format. The aim: .vtu under 0.3 s, .msh 2.2 under 2 s.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"

namespace cover {
namespace {

const Output& million() {
  static const Output output = testing::structured_mesh(1000, 500);
  return output;
}

void write(benchmark::State& state, const std::string& extension) {
  const testing::TemporaryFolder folder;
  const std::string path = (folder.path() / ("x" + extension)).string();
  const Output& output = million();
  for (auto _ : state) {
    if (const Status status = write_mesh(output, path); !status)
      state.SkipWithError(status.error().message.c_str());
  }
  state.counters["MB"] = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
}

BENCHMARK_CAPTURE(write, vtu, ".vtu")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write, vtk, ".vtk")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write, msh, ".msh")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write, xdmf, ".xdmf")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write, mesh, ".mesh")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write, inp, ".inp")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write, ele, ".ele")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write, json, ".json")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cover

BENCHMARK_MAIN();
