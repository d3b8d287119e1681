// The meshing stage beside CGAL's plain constrained Delaunay triangulation of the same output
// vertices, in the same run: absolute times depend on the machine, the ratio hardly does. Both are
// CPU times, which other programs on the machine disturb less.
//
// Counters: us_per_triangle  meshing stage, one thread, per output triangle
//           ratio            the same, divided by CGAL's time per triangle
//           steiner          Steiner vertices per input vertex
//           stage_bytes      per triangle, what the meshing stage needs at its peak; in it its
//           result bytes            the same for all of cover_mesh, input and output included
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include <cover/cover_mesh.hpp>

#include "clean/pslg.hpp"
#include "cpu_seconds.hpp"
#include "heap_peak.hpp"
#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"
#include "tasks/mesh_regions.hpp"

namespace {

using namespace cover;

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
  const double start = cpu_seconds();
  Cdt cdt;
  cdt.insert(points.begin(), points.end());
  std::vector<Cdt::Vertex_handle> handles(points.size());
  for (const auto v : cdt.finite_vertex_handles()) handles[v->info()] = v;
  for (const Segment& s : output.pslg.segments) {
    cdt.insert_constraint(handles[place[s.a.index()]], handles[place[s.b.index()]]);
  }
  benchmark::DoNotOptimize(cdt.number_of_faces());
  return cpu_seconds() - start;
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

/// As cover_mesh makes them, which has triangulated everything to find the regions.
std::vector<RegionBoundary> boundaries_of(const Input& input, const Options& options) {
  Report report;
  std::optional<Triangulation> whole;
  const auto pslg = make_pslg(input, options, report, &whole);
  if (!pslg) throw std::runtime_error(pslg.error().message);
  auto found = build_triangulated_table(*pslg, options, report.notes, std::move(whole));
  if (!found) throw std::runtime_error(found.error().message);
  std::vector<RegionBoundary> boundaries = split_regions(*pslg, found->table);
  add_known_triangles(found->triangulated, pslg->points.size(), boundaries);
  return boundaries;
}

void mesh_stage(benchmark::State& state, const std::function<Input()>& make_input,
                const std::string& method) {
  const Options options = options_for(method);
  std::optional<Result<Output>> output;
  const double bytes = bench::heap_peak_of([&] { output = cover_mesh(make_input(), options); });
  if (!output->has_value()) {
    state.SkipWithError(output->error().message.c_str());
    return;
  }
  const Report& report = (*output)->report;
  const auto triangles = static_cast<double>(report.quality.triangles);
  state.counters["triangles"] = triangles;
  state.counters["steiner"] =
      static_cast<double>(report.steiner_vertices) / static_cast<double>(report.input_points);
  state.counters["bytes"] = bytes / triangles;

  const std::vector<RegionBoundary> boundaries = boundaries_of(make_input(), options);
  const auto run = [&] { benchmark::DoNotOptimize(mesh_regions(boundaries, options, {})); };
  state.counters["stage_bytes"] = bench::heap_peak_of(run) / triangles;
  double mesh = 0, cdt = 0;
  for (auto _ : state) {
    const double start = cpu_seconds();
    run();
    const double seconds = cpu_seconds() - start;
    state.SetIterationTime(seconds);
    mesh += seconds;
    cdt += plain_cdt_seconds(**output);
  }
  state.counters["us_per_triangle"] =
      1e6 * mesh / (triangles * static_cast<double>(state.iterations()));
  state.counters["ratio"] = mesh / cdt;
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
            mesh_stage(
                state, [n] { return testing::input_of(testing::smooth_star(n, 1)); }, method);
          })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    }
    for (const int cells : {6, 18, 56, 177}) {  // 1e3 to 1e6 sides
      benchmark::RegisterBenchmark((method + "/checker/" + std::to_string(cells)).c_str(),
                                   [=](benchmark::State& state) {
                                     mesh_stage(
                                         state, [cells] { return testing::checker(cells, 8, 1); },
                                         method);
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
