// The meshing stage beside CGAL's plain constrained Delaunay triangulation of the same output
// vertices, in the same run: absolute times depend on the machine, the ratio hardly does.
//
// Counters: us_per_triangle  meshing stage, one thread, per output triangle
//           ratio            the same, divided by CGAL's time per triangle
//           steiner          Steiner vertices per input vertex
//           bytes            growth of the peak resident set per triangle (first run of a case
//           only)
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <chrono>
#include <cover/cover_mesh.hpp>
#include <string>

#include "support/inputs.hpp"

namespace {

using namespace cover;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

/// Seconds of CGAL's CDT of the output's vertices and segments, in the way that CGAL does fastest:
/// points in one range (spatially sorted), constraints between vertex handles.
double plain_cdt_seconds(const Output& output) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
      Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
  const TriMesh& mesh = output.mesh.tri();
  std::vector<std::pair<Kernel::Point_2, std::size_t>> points;
  std::vector<std::size_t> place(output.pslg.points.size());
  for (const auto v : mesh.vertices()) {
    const long id = output.mesh.input_id(v);
    if (id >= 0) place[static_cast<std::size_t>(id)] = points.size();
    points.emplace_back(Kernel::Point_2(mesh.point(v)[0], mesh.point(v)[1]), points.size());
  }
  const auto start = Clock::now();
  Cdt cdt;
  cdt.insert(points.begin(), points.end());
  std::vector<Cdt::Vertex_handle> handles(points.size());
  for (const auto v : cdt.finite_vertex_handles()) handles[v->info()] = v;
  for (const Segment& s : output.pslg.segments) {
    cdt.insert_constraint(handles[place[s.a.index()]], handles[place[s.b.index()]]);
  }
  benchmark::DoNotOptimize(cdt.number_of_faces());
  return seconds_since(start);
}

double stage_seconds(const Report& report, const std::string& stage) {
  for (const StageTime& time : report.times) {
    if (time.stage == stage) return time.seconds;
  }
  return 0;
}

Options options_for(const std::string& method) {
  Options options;
  options.threads = 1;
  options.method = method == "quality" ? Method::quality : Method::almond;
  options.paper = method == "paper";
  return options;
}

void mesh_stage(benchmark::State& state, const Input& input, const std::string& method) {
  const Options options = options_for(method);
  const double before = peak_bytes();
  double mesh = 0, cdt = 0;
  std::size_t triangles = 0, steiner = 0, points = 1;
  double bytes = 0;
  for (auto _ : state) {
    const auto output = cover_mesh(input, options);
    if (!output) {
      state.SkipWithError(output.error().message.c_str());
      return;
    }
    if (bytes == 0) bytes = peak_bytes() - before;
    const double seconds = stage_seconds(output->report, "mesh");
    state.SetIterationTime(seconds);
    mesh += seconds;
    cdt += plain_cdt_seconds(*output);
    triangles = output->report.quality.triangles;
    steiner = output->report.steiner_vertices;
    points = output->report.input_points;
  }
  const auto count = static_cast<double>(triangles);
  state.counters["triangles"] = count;
  state.counters["us_per_triangle"] =
      1e6 * mesh / (count * static_cast<double>(state.iterations()));
  state.counters["ratio"] = mesh / cdt;
  state.counters["steiner"] = static_cast<double>(steiner) / static_cast<double>(points);
  state.counters["bytes"] = bytes / count;
}

/// The same mesh with one thread and with two.
void two_threads(benchmark::State& state, const std::string& method) {
  const Input input = testing::checker(static_cast<int>(state.range(0)), 8, 1);
  Options options = options_for(method);
  double one = 0, two = 0;
  for (auto _ : state) {
    options.threads = 1;
    const auto a = cover_mesh(input, options);
    options.threads = 2;
    const auto b = cover_mesh(input, options);
    if (!a || !b) {
      state.SkipWithError("meshing failed");
      return;
    }
    one += stage_seconds(a->report, "mesh");
    two += stage_seconds(b->report, "mesh");
    state.SetIterationTime(stage_seconds(b->report, "mesh"));
  }
  state.counters["speedup"] = one / two;
}

void register_all() {
  for (const std::string method : {"almond", "paper", "quality"}) {
    for (const int n : {1000, 10000, 100000, 1000000}) {
      benchmark::RegisterBenchmark(
          (method + "/smooth_star/" + std::to_string(n)).c_str(),
          [=](benchmark::State& state) {
            mesh_stage(state, testing::input_of(testing::smooth_star(n, 1)), method);
          })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    }
    for (const int cells : {6, 18, 56, 177}) {  // 1e3 to 1e6 sides
      benchmark::RegisterBenchmark((method + "/checker/" + std::to_string(cells)).c_str(),
                                   [=](benchmark::State& state) {
                                     mesh_stage(state, testing::checker(cells, 8, 1), method);
                                   })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    }
    benchmark::RegisterBenchmark((method + "/two_threads").c_str(),
                                 [=](benchmark::State& state) { two_threads(state, method); })
        ->Arg(100)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
