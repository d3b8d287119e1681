// A region goes to the disk as soon as it is done, whichever comes first; what a file wants in
// order, it gets when all are there. Lines of a mesh are segments: of each is kept which of the
// half-edges of its region it is first, so that they come in the order of a mesh in memory.
//
// Tested by tests/unit/stream/stream_mesh_test.cpp and, with the program, by
// tests/cli/large_mesh_test.py.
#include <cover/files.hpp>
#include <cover/periodic.hpp>
#include <cover/pslg.hpp>
#include <cover/stream_mesh.hpp>

#include <filesystem>
#include <random>
#include <utility>

#include <fmt/core.h>

#include "base/containers/give_back.hpp"
#include "base/faults/errors.hpp"
#include "base/faults/internal_fault.hpp"
#include "base/faults/out_of_memory.hpp"
#include "io/files/temporary_file.hpp"
#include "io/report/report_text.hpp"
#include "io/write_mesh/write_spooled.hpp"
#include "layers/layer_rules.hpp"
#include "mesh/stitch.hpp"
#include "pipeline/steps.hpp"
#include "region/region_graph.hpp"
#include "sizes/expected_triangles.hpp"
#include "stream/keep_bytes.hpp"
#include "stream/spool_region.hpp"
#include "stream/spooled_parts.hpp"
#include "target/report/measure_angles.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/followed_run.hpp"
#include "tasks/mesh_regions.hpp"
#include "tasks/share_out_regions.hpp"

namespace cover {
namespace {

/// Puts regions into the spool file, and keeps what lines and reports need.
class Spooler {
 public:
  Spooler(const Pslg& pslg, const RegionTable& table, std::vector<RegionBoundary>& boundaries,
          MeshSpool& spool, std::vector<std::uint32_t> vertex_of)
      : pslg_(pslg),
        table_(table),
        boundaries_(boundaries),
        spool_(spool),
        vertex_of_(std::move(vertex_of)),
        first_half_edge_(pslg.segments.size(), kNone),
        reports_(boundaries.size()) {}

  void take(std::size_t region, RegionMesh mesh) {
    RegionBoundary& boundary = boundaries_[region];
    reports_[region] = std::move(mesh.report);
    note_lines(boundary, spool_region(region, boundary, vertices(region), std::move(mesh), spool_));
    boundary = {};
  }

  /// Takes what is told of a region whose mesh is in another process.
  void take_elsewhere(std::size_t region, KeptMesh mesh) {
    RegionBoundary& boundary = boundaries_[region];
    if (mesh.half_edges.size() != boundary.sides.size())
      throw InternalFault("another process told of another region", {boundary.points.front()});
    reports_[region] = std::move(mesh.report);
    spool_.add_elsewhere(region, mesh.steiner, mesh.triangles);
    note_lines(boundary, mesh.half_edges);
    boundary = {};
  }

  /// The numbers that the vertices of a region have in the mesh.
  [[nodiscard]] std::vector<VertexId> vertices(std::size_t region) const {
    std::vector<VertexId> numbers;
    numbers.reserve(boundaries_[region].vertices.size());
    for (const VertexId v : boundaries_[region].vertices)
      numbers.emplace_back(vertex_of_[v.index()]);
    return numbers;
  }

  /// What is kept in memory; to be called once.
  SpooledParts finish(Report& report, const WriteElsewhere& elsewhere) {
    for (const RegionReport& region : reports_) {
      merge(report.quality, region.quality);
      report.steiner_vertices += region.steiner_vertices;
    }
    report.regions = std::move(reports_);
    const bool is_whole = spool_.has_all();
    return {std::move(spool_), std::move(vertex_of_), std::move(first_half_edge_),
            is_whole ? WriteElsewhere() : elsewhere};
  }

 private:
  /// One region alone writes to the place of a segment, so that threads do not meet.
  void note_lines(const RegionBoundary& boundary, std::span<const std::uint32_t> half_edges) {
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      const SegmentId id = boundary.segments[s];
      if (id == kHullSide || first_region(table_.sides[id.index()]) != boundary.id) continue;
      std::uint32_t& first = first_half_edge_[id.index()];
      if (half_edges[s] == kNone) continue;
      const bool is_back = boundary.vertices[boundary.sides[s][0]] != pslg_.segments[id.index()].a;
      first = std::min(first, 2 * half_edges[s] + (is_back ? 1 : 0));
    }
  }

  const Pslg& pslg_;
  const RegionTable& table_;
  std::vector<RegionBoundary>& boundaries_;
  MeshSpool& spool_;
  std::vector<std::uint32_t> vertex_of_;        ///< by VertexId
  std::vector<std::uint32_t> first_half_edge_;  ///< by SegmentId, in its first region
  std::vector<RegionReport> reports_;
};

/// By Euler's count: each edge has two sides, and those of the outline one triangle.
MeshCounts count_of(const SpooledParts& parts, const RegionTable& table) {
  std::size_t outer = 0;
  for (std::size_t s = 0; s < table.sides.size(); ++s) {
    const bool is_outer = (table.sides[s].left == kVoid) != (table.sides[s].right == kVoid);
    outer += is_outer && parts.first_half_edge[s] != kNone ? 1 : 0;
  }
  const std::size_t triangles = parts.spool.triangles();
  return {parts.spool.vertices(), (3 * triangles + outer) / 2, triangles};
}

/// About what the mesh will take.
double expected_triangles_of(std::span<const RegionBoundary> boundaries, const Options& options) {
  double all = 0;
  for (const RegionBoundary& boundary : boundaries) all += about_triangles(boundary, options);
  return all;
}

/// What is surely needed: expected numbers of triangles may be wrong by a factor of two.
Status check_room_for(double triangles, const std::string& path) {
  constexpr double kSpooled = 44, kWritten = 80, kSurely = 0.5;
  return check_room(path, kSurely * (kSpooled + kWritten) * triangles);
}

/// Offers to other processes that they keep what they mesh beside the file `beside`.
bool offer_to_keep(const std::string& beside, std::size_t input_vertices, std::size_t regions,
                   const std::function<bool(const Bytes& how)>& offer) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const Result<fs::path> target = end_of_links(fs::absolute(beside, failed));
  if (failed || !target) return false;
  Result<TemporaryFile> seen = TemporaryFile::beside(*target, beside, {}, {});
  if (!seen) return false;
  std::random_device dice;
  const std::uint64_t word = std::uniform_int_distribution<std::uint64_t>()(dice);
  seen->write({reinterpret_cast<const char*>(&word), sizeof word});
  return offer(bytes_of(
      OfferToKeep{target->string(), seen->path().string(), word, input_vertices, regions}));
}

/// Meshes the regions into a spool file.
Result<StreamedOutput> spool_work(Work work, const Options& options, const StreamOptions& stream,
                                  const Callbacks& callbacks, StageClock& clock) {
  std::vector<std::uint32_t> vertex_of = input_vertices(work.pslg, work.boundaries);
  std::vector<Point> input;
  for (std::size_t v = 0; v < vertex_of.size(); ++v)
    if (vertex_of[v] != kNone) input.push_back(work.pslg.points[v]);
  Result<MeshSpool> spool = MeshSpool::beside(stream.beside, input, work.boundaries.size());
  if (!spool) return std::move(spool).error();
  give_back(input);
  Spooler spooler(work.pslg, work.table, work.boundaries, *spool, std::move(vertex_of));
  const Staying staying{
      [&](const std::function<bool(const Bytes& how)>& offer) {
        return offer_to_keep(stream.beside, spool->input_vertices(), work.boundaries.size(), offer);
      },
      [&](std::size_t region) { return spooler.vertices(region); },
      [&](std::size_t region, KeptMesh mesh) { spooler.take_elsewhere(region, std::move(mesh)); }};
  Status meshed = mesh_regions_into(
      work.boundaries, options, callbacks,
      [&](std::size_t region, RegionMesh mesh) { spooler.take(region, std::move(mesh)); },
      [&] { return spool->is_good(); },
      stream.may_stay && callbacks.write_elsewhere ? &staying : nullptr);
  if (!meshed) return std::move(meshed).error();
  return errors_as_values("stream", [&]() -> Result<StreamedOutput> {
    if (Status finished = spool->finish(); !finished) return std::move(finished).error();
    clock.note("mesh", work.report.times);
    auto parts = std::make_shared<const SpooledParts>(
        spooler.finish(work.report, callbacks.write_elsewhere));
    const MeshCounts counts = count_of(*parts, work.table);
    return StreamedOutput{
        Output{Mesh(), std::move(work.pslg), std::move(work.table), std::move(work.report)}, counts,
        std::move(parts)};
  });
}

Result<StreamedOutput> stream_or_hold(Input input, const Options& asked,
                                      const StreamOptions& stream, const Callbacks& callbacks) {
  StageClock clock;
  const Options options = with_layers_of(input, asked);
  Result<Work> work = begin_work(std::move(input), options, Held::one_region, callbacks, clock);
  if (!work) return std::move(work).error();
  Result<double> expected = errors_as_values(
      "estimate", [&] { return Result<double>(expected_triangles_of(work->boundaries, options)); });
  if (!expected) return std::move(expected).error();
  if (*expected < stream.most_in_memory) {
    Result<Output> output = finish_work(*std::move(work), options, callbacks, clock);
    if (!output) return std::move(output).error();
    const MeshCounts counts = count_of(output->mesh);
    return StreamedOutput{*std::move(output), counts, nullptr};
  }
  if (Status room = check_room_for(*expected, stream.beside); !room) return std::move(room).error();
  return spool_work(*std::move(work), options, stream, callbacks, clock);
}

/// Those that are in the mesh, by their numbers there.
std::vector<NamedPoint> named_points_of(const Pslg& pslg, const SpooledParts& parts) {
  std::vector<NamedPoint> named;
  for (const NamedPoint& point : pslg.named_points) {
    const std::uint32_t v = parts.vertex_of[point.vertex.index()];
    if (v != kNone) named.push_back({VertexId(v), point.name});
  }
  return named;
}

}  // namespace

RegionId first_region(const SegmentSides& sides) {
  if (sides.left == kVoid) return sides.right;
  if (sides.right == kVoid) return sides.left;
  return std::min(sides.left, sides.right);
}

std::vector<LineEdge> lines_of(const Pslg& pslg, const RegionTable& table,
                               const SpooledParts& parts) {
  constexpr unsigned kBitsOfHalfEdge = 32;
  std::vector<LineEdge> lines;
  lines.reserve(pslg.segments.size());
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const std::uint32_t first = parts.first_half_edge[s];
    if (first == kNone) continue;
    const SegmentSides& sides = table.sides[s];
    const Segment& segment = pslg.segments[s];
    LineEdge line;
    line.interface = sides.interface;
    line.marker = segment.marker;
    line.order = static_cast<std::uint64_t>(first_region(sides).value()) << kBitsOfHalfEdge | first;
    line.from = parts.vertex_of[segment.a.index()];
    line.to = parts.vertex_of[segment.b.index()];
    if (first % 2 == 1) std::swap(line.from, line.to);
    line.is_inner = sides.left != kVoid && sides.right != kVoid;
    lines.push_back(line);
  }
  return lines;
}

MeshView view_of_lines(const StreamedOutput& output, const WriteOptions& options) {
  const Output& rest = output.output;
  return view_of_lines(rest.table, lines_of(rest.pslg, rest.table, *output.parts), options,
                       named_points_of(rest.pslg, *output.parts));
}

std::string needs_whole_mesh(const Input& input, const Options& options) {
  if (options.method == Method::nonobtuse) return "method nonobtuse";
  if (options.hull) return "the convex hull as the domain";
  if (options.split_interfaces || options.box_method) return "cutting segments after meshing";
  if (!periodic_rules(input, options).empty()) return "periodic sides";
  if (!input.circles.empty()) return "arcs";
  if (!input.attributes.empty()) return "keeping attributes of a map";
  if (input.field) return "carrying values at points";
  return {};
}

std::string needs_whole_mesh(const std::string& path, const WriteOptions& options) {
  if (options.order != 1) return "triangles of second order";
  if (options.parts != 1) return "a mesh in parts";
  if (can_write_spooled(path, options)) return {};
  WriteOptions in_hdf5 = options;
  in_hdf5.xdmf = "hdf5";
  if (can_write_spooled(path, in_hdf5))
    return "an .xdmf with its numbers as text (not with the option xdmf as hdf5)";
  return fmt::format("a file in {}", extension_of(path));
}

bool can_write_from_elsewhere(const std::string& path, const WriteOptions& options) {
  return needs_whole_mesh(path, options).empty() && is_written_by_columns(path);
}

Result<StreamedOutput> stream_mesh(Input&& input, const Options& options,
                                   const StreamOptions& stream, const Callbacks& caller) {
  if (const std::string why = needs_whole_mesh(input, options); !why.empty())
    return bad_option(why + " needs the whole mesh in memory: cover_mesh() makes that");
  return followed("mesh", caller, [&](const Callbacks& callbacks) {
    return stream_or_hold(std::move(input), options, stream, callbacks);
  });
}

Status write_streamed_mesh(const StreamedOutput& output, const std::string& path,
                           const WriteOptions& options) {
  return memory_as_value(path, [&]() -> Status {
    if (!output.is_streamed())
      return bad_option(path + ": the mesh is not on the disk; write_mesh() writes one in memory");
    if (Status status = can_write(path, options); !status) return status;
    if (const std::string why = needs_whole_mesh(path, options); !why.empty())
      return bad_option(fmt::format("{}: {} needs the whole mesh in memory", path, why));
    const Output& rest = output.output;
    const SpooledParts& parts = *output.parts;
    if (parts.elsewhere && !can_write_from_elsewhere(path, options))
      return bad_option(path + ": some regions are in other processes");
    decltype(SpooledMesh::elsewhere) elsewhere;
    if (parts.elsewhere)
      elsewhere = [&](const ColumnPlan& plan, const std::function<Status()>& here) {
        return parts.elsewhere(bytes_of(plan), here);
      };
    return write_spooled({parts.spool, rest.table, rest.report, rest.pslg.segments.size(),
                          [&] { return lines_of(rest.pslg, rest.table, parts); },
                          named_points_of(rest.pslg, parts), rest.report.threads, elsewhere},
                         path, options);
  });
}

std::string report_json(const StreamedOutput& output) {
  return report_json(output.output, output.counts);
}

Status write_report_json(const StreamedOutput& output, const std::string& path) {
  return write_report_json(output.output, output.counts, path);
}

}  // namespace cover
