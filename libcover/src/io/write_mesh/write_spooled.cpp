// Each array of a file is one pass over the spool file.
// Tested by tests/unit/stream/stream_mesh_test.cpp, against the files of the same mesh in
// memory.
#include "io/write_mesh/write_spooled.hpp"

#include <algorithm>
#include <string_view>

#include <cover/files.hpp>

#include "base/run_all.hpp"
#include "io/files/atomic_file.hpp"
#include "io/write_mesh/solver_formats/msh_text.hpp"
#include "io/write_mesh/solver_formats/xdmf_file.hpp"
#include "io/write_mesh/vtk_formats/vtkhdf_file.hpp"
#include "io/write_mesh/vtk_formats/vtu_parts.hpp"

namespace cover {
namespace {

/// The arrays of a grid, read as they are written. The first failure to read is kept.
class SpooledArrays {
 public:
  explicit SpooledArrays(const SpooledMesh& mesh) : spool_(mesh.spool), table_(mesh.table) {}

  VtuGrid grid() {
    TriangleArrays arrays;
    arrays.triangles = spool_.triangles();
    arrays.material = by_region([](const Region& region) { return region.material; });
    arrays.region = by_region([](const Region& region) { return region.id.value(); });
    arrays.largest = angles(true);
    arrays.smallest = angles(false);
    return grid_of(
        arrays, spool_.vertices(),
        [this](BinaryWriter& out) {
          keep(spool_.each_vertex([&](std::span<const Point> places) {
            for (const Point& place : places) put_place(place, out);
          }));
        },
        nodes());
  }

  XdmfSource xdmf(const MeshView& view) {
    return {view,
            spool_.vertices(),
            spool_.triangles(),
            3,
            [this](BinaryWriter& out) {
              keep(spool_.each_vertex([&](std::span<const Point> places) {
                for (const Point& place : places) {
                  out.put(place.x);
                  out.put(place.y);
                }
              }));
            },
            nodes(),
            by_region([](const Region& region) { return region.material; }),
            by_region([](const Region& region) { return region.id.value(); }),
            by_region([&view](const Region& region) {
              return view.region_groups[view.region_group[place_of(region.id)]].tag;
            })};
  }

  [[nodiscard]] const Status& status() const { return status_; }

 private:
  ArrayWriter nodes() {
    return [this](BinaryWriter& out) {
      keep(spool_.each_triangle([&](std::size_t, std::span<const IndexTriple> triangles) {
        for (const IndexTriple& t : triangles)
          for (const std::uint32_t v : t) out.put(static_cast<std::int64_t>(v));
      }));
    };
  }

  template <class Value>
  ArrayWriter by_region(Value value) {
    return [this, value](BinaryWriter& out) {
      for (std::size_t r = 0; r < spool_.regions(); ++r) {
        const auto number = static_cast<std::int32_t>(value(table_.regions[r]));
        for (std::size_t k = 0; k < spool_.triangles(r); ++k) out.put(number);
      }
    };
  }
  ArrayWriter angles(bool largest) {
    return [this, largest](BinaryWriter& out) {
      keep(spool_.each_angle(largest, [&](std::span<const double> values) {
        for (const double value : values) out.put(value);
      }));
    };
  }
  void keep(Status status) {
    if (status_ && !status) status_ = std::move(status);
  }

  const MeshSpool& spool_;
  const RegionTable& table_;
  Status status_ = ok();
};

/// For text, by group of regions.
class SpooledCells final : public CellSource {
 public:
  SpooledCells(const SpooledMesh& mesh, const MeshView& view, std::vector<Point> input)
      : spool_(mesh.spool), table_(mesh.table), input_(std::move(input)) {
    groups_.resize(view.region_groups.size());
    for (std::uint32_t r = 0; r < view.region_group.size(); ++r)
      groups_[view.region_group[r]].push_back(r);
  }

  [[nodiscard]] std::size_t points() const override { return spool_.vertices(); }
  [[nodiscard]] std::size_t triangles() const override { return spool_.triangles(); }
  [[nodiscard]] std::size_t triangles(std::size_t group) const override {
    std::size_t n = 0;
    for (const std::uint32_t r : groups_[group]) n += spool_.triangles(r);
    return n;
  }
  void each_point(const std::function<void(Point)>& use) const override {
    keep(spool_.each_vertex([&](std::span<const Point> places) {
      for (const Point& place : places) use(place);
    }));
  }
  void each_triangle(const Use& use) const override { keep(spool_.each_triangle(each(use))); }
  void each_triangle(std::size_t group, const Use& use) const override {
    keep(spool_.triangles_of(groups_[group], each(use)));
  }
  [[nodiscard]] Point line_point(std::uint32_t node) const override { return input_[node]; }
  /// Steiner vertices lie inside of what the others bound.
  [[nodiscard]] Box box(std::size_t group) const override {
    Box box;
    keep(spool_.triangles_of(groups_[group],
                             [&](std::size_t, std::span<const IndexTriple> triangles) {
                               for (const IndexTriple& t : triangles)
                                 for (const std::uint32_t v : t)
                                   if (v < input_.size()) box.add(input_[v]);
                             }));
    return box;
  }

  [[nodiscard]] const Status& status() const { return status_; }

 private:
  [[nodiscard]] MeshSpool::Corners each(const Use& use) const {
    return [this, &use](std::size_t r, std::span<const IndexTriple> triangles) {
      for (const IndexTriple& t : triangles) use(table_.regions[r].id, t);
    };
  }
  void keep(Status status) const {
    if (status_ && !status) status_ = std::move(status);
  }

  const MeshSpool& spool_;
  const RegionTable& table_;
  std::vector<Point> input_;
  std::vector<std::vector<std::uint32_t>> groups_;  ///< regions from 0 on
  mutable Status status_ = ok();
};

Status write_spooled_vtu(const SpooledMesh& mesh, const std::string& path,
                         const WriteOptions& options) {
  SpooledArrays arrays(mesh);
  Result<AtomicFile> file = AtomicFile::create(path, options.stop);
  if (!file) return std::move(file).error();
  write_vtu_bytes(arrays.grid(), [&](std::string_view bytes) { file->write(bytes); });
  return arrays.status() ? file->commit() : arrays.status();
}

/// Adds what is known of the mesh.
void complete_plan(const SpooledMesh& mesh, ColumnPlan& plan) {
  plan.input_vertices = mesh.spool.input_vertices();
  plan.regions.reserve(mesh.spool.regions());
  for (std::size_t r = 0; r < mesh.spool.regions(); ++r)
    plan.regions.push_back({static_cast<std::uint32_t>(mesh.spool.steiner(r)),
                            static_cast<std::uint32_t>(mesh.spool.triangles(r)),
                            mesh.table.regions[r].material});
}

Status write_spooled_vtkhdf(const SpooledMesh& mesh, const std::string& path,
                            const WriteOptions& options) {
  WriteOptions all = options;
  all.inner_lines = true;
  const MeshView lines = view_of_lines(mesh.table, mesh.lines(), all, mesh.named);
  SpooledArrays arrays(mesh);
  const VtkHdfSource source{mesh.table,    mesh.report, lines,
                            arrays.grid(), 3,           mesh.spool.input_vertices()};
  if (!is_written_by_columns(path))
    return write_vtkhdf_file(source, path, options.stop, [&] { return arrays.status(); });
  return write_vtkhdf_columns(source, path, options.stop, [&](ColumnPlan plan) {
    complete_plan(mesh, plan);
    const auto here = [&] {
      Status status = ok();
      with_team(mesh.threads, [&](const Team& team) {
        status = write_columns(mesh.spool, plan, options.stop, team);
      });
      return status;
    };
    return mesh.elsewhere ? mesh.elsewhere(plan, here) : here();
  });
}

Status write_spooled_msh(const SpooledMesh& mesh, const std::string& path,
                         const WriteOptions& options) {
  const MeshView view = view_of_lines(mesh.table, mesh.lines(), options, mesh.named);
  Result<std::vector<Point>> input = mesh.spool.input_points();
  if (!input) return std::move(input).error();
  const SpooledCells cells(mesh, view, *std::move(input));
  Result<TextWriter> out = TextWriter::create(path, options.stop);
  if (!out) return std::move(out).error();
  write_msh_text(view, cells, mesh.table, options.msh, *out);
  return cells.status() ? out->commit() : cells.status();
}

Status write_spooled_xdmf(const SpooledMesh& mesh, const std::string& path,
                          const WriteOptions& options) {
  const MeshView view = view_of_lines(mesh.table, mesh.lines(), options, mesh.named);
  SpooledArrays arrays(mesh);
  return write_xdmf_file(arrays.xdmf(view), path, options.stop, [&] { return arrays.status(); });
}

/// What files take at the most, in bytes: for room on the disk.
struct BytesPer {
  double triangle, vertex;
};
constexpr BytesPer kNumbers{65, 24}, kText{45, 56};
constexpr double kBytesPerLine = 24, kBytesPerRegion = 64;

struct SpooledFormat {
  std::string_view extension;
  Status (*write)(const SpooledMesh&, const std::string& path, const WriteOptions&);
  BytesPer bytes = kNumbers;
  bool by_columns = false;
};

constexpr SpooledFormat kSpooled[] = {
    {".vtu", write_spooled_vtu},
    {".vtkhdf", write_spooled_vtkhdf, kNumbers, true},
    {".msh", write_spooled_msh, kText},
    {".xdmf", write_spooled_xdmf},
};

/// Null: its files want the whole mesh.
const SpooledFormat* spooled_format(const std::string& path) {
  const std::string extension = extension_of(path);
  const auto* const found =
      std::find_if(std::begin(kSpooled), std::end(kSpooled),
                   [&](const SpooledFormat& format) { return format.extension == extension; });
  return found != std::end(kSpooled) ? found : nullptr;
}

double size_of_file(const SpooledMesh& mesh, const BytesPer& bytes) {
  return bytes.triangle * static_cast<double>(mesh.spool.triangles()) +
         bytes.vertex * static_cast<double>(mesh.spool.vertices()) +
         kBytesPerLine * static_cast<double>(mesh.line_count) +
         kBytesPerRegion * static_cast<double>(mesh.spool.regions());
}

}  // namespace

bool can_write_spooled(const std::string& path, const WriteOptions& options) {
  const SpooledFormat* const format = spooled_format(path);
  if (format == nullptr || options.parts != 1) return false;
  return format->write != write_spooled_xdmf || options.xdmf == "hdf5";
}

bool is_written_by_columns(const std::string& path) {
  const SpooledFormat* const format = spooled_format(path);
  return format != nullptr && format->by_columns && !is_written_directly(path);
}

Status write_spooled(const SpooledMesh& mesh, const std::string& path,
                     const WriteOptions& options) {
  const SpooledFormat& format = *spooled_format(path);
  if (Status status = check_room(path, size_of_file(mesh, format.bytes)); !status) return status;
  return format.write(mesh, path, options);
}

}  // namespace cover
