// VTKHDF 1.0, an unstructured grid of one piece: the triangles and arrays of a .vtu, and as field
// data all that the .vtm and the manifest know, so that one file is enough.
// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtkhdf_test.cpp.
#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include <cover/mesh.hpp>
#include <cover/write_mesh.hpp>

#include "base/run_all.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/temporary_file.hpp"
#include "io/hdf5/hdf5_writer.hpp"
#include "io/text/array_names.hpp"
#include "io/write_mesh/check_format.hpp"
#include "io/write_mesh/placed_file.hpp"
#include "io/write_mesh/vtk_formats/vtkhdf_file.hpp"
#include "io/write_mesh/vtk_formats/vtu_parts.hpp"

namespace cover {
namespace {

const std::string kRoot = "/VTKHDF/";
const std::string kFields = kRoot + "FieldData/";

class VtkHdfContent {
 public:
  explicit VtkHdfContent(const VtkHdfSource& source) : source_(source), view_(source.lines) {
    // Sides of the hull are on no interface.
    for (std::size_t l = 0; l < view_.lines.size(); ++l)
      if (view_.interface[l] != kNoInterface) lines_.push_back(static_cast<std::uint32_t>(l));
  }

  Hdf5Content make() {
    for (const char* group : {"", "CellData", "PointData", "FieldData"})
      content_.groups.push_back(kRoot + group);
    content_.attributes = {{kRoot, "Version", {1, 0}, {}}, {kRoot, "Type", {}, "UnstructuredGrid"}};
    cells();
    regions();
    lines();
    points();
    origin();
    order();
    return std::move(content_);
  }

 private:
  void cells() {
    const VtuGrid& grid = source_.grid;
    const std::size_t each = source_.nodes_each, count = grid.cells;
    number("NumberOfPoints", grid.points);
    number("NumberOfCells", count);
    number("NumberOfConnectivityIds", each * count);
    add(kRoot, "Points", grid.coordinates);
    add(kRoot, "Connectivity", grid.connectivity[0]);
    add(kRoot, "Offsets",
        vtu_array<std::int64_t>("", count + 1, [each](std::size_t k) { return k * each; }));
    add(kRoot, "Types", grid.connectivity[2]);
    for (const VtuArray& array : grid.point_data) add(kRoot + "PointData/", array.name, array);
    for (const VtuArray& array : grid.cell_data) add(kRoot + "CellData/", array.name, array);
  }

  void regions() {
    const std::vector<Region>& all = source_.table.regions;
    texts("RegionName", all, [](const Region& region) { return region.name; });
    texts("MaterialName", all, [](const Region& region) { return region.material_name; });
    numbers<std::int32_t>("RegionMaterial", all.size(),
                          [&all](std::size_t r) { return all[r].material; });
    for (const Attribute& attribute : view_.attributes)
      if (attribute.is_text)
        texts(words_name(attribute.name).c_str(), attribute.words,
              [](const std::string& word) { return word; });
  }

  void points() {
    if (view_.named.empty()) return;
    texts("PointName", view_.named_group,
          [this](std::uint32_t group) { return view_.point_groups[group].original; });
    numbers<std::int64_t>("PointVertex", view_.named.size(),
                          [this](std::size_t k) { return view_.named[k]; });
  }

  void lines() {
    const std::vector<Interface>& all = source_.table.interfaces;
    texts("LineName", all, [](const Interface& line) { return line.name; });
    const auto of_line = [&](const char* name, auto value) {
      numbers<std::int32_t>(name, all.size(),
                            [&all, value](std::size_t k) { return value(all[k]); });
    };
    of_line("LineKind", [](const Interface& line) { return static_cast<int>(line.kind); });
    of_line("LeftRegion", [](const Interface& line) { return line.left.value(); });
    of_line("RightRegion", [](const Interface& line) { return line.right.value(); });
    const std::size_t each = view_.lines.nodes_each;
    VtuArray nodes = vtu_array<std::int64_t>("", each * lines_.size(), [this, each](std::size_t k) {
      return view_.lines[lines_[k / each]][k % each];
    });
    nodes.components = each;
    add(kFields, "LineNodes", nodes);
    numbers<std::int32_t>("LineID", lines_.size(),
                          [this](std::size_t k) { return view_.interface[lines_[k]].value(); });
    numbers<std::int32_t>("LineMarker", lines_.size(),
                          [this](std::size_t k) { return view_.marker[lines_[k]]; });
  }

  /// Where the mesh comes from.
  void origin() {
    numbers<std::int64_t>("InputVertices", 1,
                          [this](std::size_t) { return source_.input_vertices; });
    if (source_.grid.cut_vertices > 0)
      numbers<std::int64_t>("CutVertices", 1,
                            [this](std::size_t) { return source_.grid.cut_vertices; });
    const Provenance& from = source_.report.provenance;
    const auto text = [&](const char* name, const std::string& value) {
      if (!value.empty()) content_.texts.push_back({kFields + name, {value}});
    };
    text("Source", from.source);
    text("CoverVersion", from.version);
    text("Unit", source_.report.unit);
    numbers<double>("Scale", 1, [scale = source_.report.scale](std::size_t) { return scale; });
    using Setting = Provenance::Setting;
    texts("OptionName", from.settings, [](const Setting& setting) { return setting.name; });
    texts("OptionValue", from.settings, [](const Setting& setting) { return setting.value; });
  }

  /// HDF5 sorts by name what stands in a group: where the input has another order, that is listed,
  /// attributes of regions first.
  void order() {
    std::vector<std::string> attributes, fields;
    for (const Attribute& attribute : view_.attributes) attributes.push_back(attribute.name);
    for (const PlaneField::Array& field : view_.fields) fields.push_back(field.name);
    if (std::is_sorted(attributes.begin(), attributes.end()) &&
        std::is_sorted(fields.begin(), fields.end()))
      return;
    attributes.insert(attributes.end(), fields.begin(), fields.end());
    content_.texts.push_back({kFields + kArrayOrder, std::move(attributes)});
  }

  void add(const std::string& folder, const std::string& name, const VtuArray& array) {
    const std::uint64_t items = array.bytes / size_of(array.type) / array.components;
    std::vector<std::uint64_t> shape{items};
    if (array.components > 1) shape.push_back(array.components);
    content_.numbers.push_back({folder + name, array.type, shape, array.write});
  }
  void number(const char* name, std::size_t value) {
    add(kRoot, name, vtu_array<std::int64_t>("", 1, [value](std::size_t) { return value; }));
  }
  template <class T, class Value>
  void numbers(const char* name, std::size_t size, Value value) {
    add(kFields, name, vtu_array<T>("", size, value));
  }
  template <class Item, class Text>
  void texts(const char* name, const std::vector<Item>& items, Text text) {
    Hdf5Texts out{kFields + name, {}};
    for (const Item& item : items) out.texts.push_back(text(item));
    content_.texts.push_back(std::move(out));
  }

  const VtkHdfSource& source_;
  const MeshView& view_;
  std::vector<std::uint32_t> lines_;  ///< those on interfaces, as numbers in the view
  Hdf5Content content_;
};

/// The arrays whose numbers belong to regions.
std::optional<Column> column_of(const std::string& path) {
  static constexpr std::array<std::pair<std::string_view, Column>, 10> kColumns{
      {{"Points", Column::places},
       {"Connectivity", Column::corners},
       {"Offsets", Column::ends},
       {"Types", Column::types},
       {"CellData/material", Column::material},
       {"CellData/MaterialID", Column::material},
       {"CellData/mat_id", Column::material},
       {"CellData/RegionId", Column::region},
       {"CellData/max_angle", Column::largest},
       {"CellData/min_angle", Column::smallest}}};
  for (const auto& [name, column] : kColumns)
    if (path == kRoot + std::string(name)) return column;
  return std::nullopt;
}

/// Puts all numbers of a data set to their place.
void write_numbers(const Hdf5Plan::Extent& extent, PlacedFile& file) {
  std::uint64_t at = extent.at;
  const ByteSink sink = [&](std::string_view bytes) {
    file.write(at, bytes);
    at += bytes.size();
  };
  BinaryWriter out(sink);
  extent.data->write(out);
  out.flush();
}

std::string absolute_path(const std::filesystem::path& path) {
  std::error_code failed;
  const std::filesystem::path absolute = std::filesystem::absolute(path, failed);
  return failed ? path.string() : absolute.string();
}

}  // namespace

Status write_vtkhdf_file(const VtkHdfSource& source, const std::string& path,
                         const std::stop_token& stop, const std::function<Status()>& status) {
  VtkHdfContent content(source);
  Result<AtomicFile> file = AtomicFile::create(path, stop);
  if (!file) return std::move(file).error();
  Status written = write_hdf5(content.make(), [&](std::string_view bytes) { file->write(bytes); });
  if (written) written = status();
  return written ? file->commit() : written;
}

Status write_vtkhdf_columns(const VtkHdfSource& source, const std::string& path,
                            const std::stop_token& stop,
                            const std::function<Status(ColumnPlan)>& write) {
  VtkHdfContent content(source);
  const Hdf5Content made = content.make();
  Result<Hdf5Plan> layout = lay_out_hdf5(made);
  if (!layout) return std::move(layout).error();
  Result<AtomicFile> file = AtomicFile::create(path, stop);
  if (!file) return std::move(file).error();
  if (file->temporary_path().empty()) return cannot_write(path, ESPIPE);
  ColumnPlan plan{absolute_path(file->temporary_path()), path, 0, {}, {}};
  Result<PlacedFile> placed = PlacedFile::open(plan.path, path, stop);
  if (!placed) return std::move(placed).error();
  placed->resize(layout->size);
  layout->each_structure(
      [&](std::uint64_t at, std::string_view bytes) { placed->write(at, bytes); });
  for (const Hdf5Plan::Extent& extent : layout->extents) {
    if (const auto column = column_of(extent.data->path)) {
      plan.columns.push_back({*column, extent.at});
    } else {
      write_numbers(extent, *placed);
    }
  }
  if (Status written = placed->finish(); !written) return written;
  if (Status written = write(std::move(plan)); !written) return written;
  return file->commit();
}

Status write_vtkhdf(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".vtkhdf", output, path, options); !status) return status;
  WriteOptions all = options;
  all.inner_lines = true;
  const MeshView view = view_of(output, all);
  std::size_t input_vertices = 0;
  for (const auto v : output.mesh.tri().vertices())
    input_vertices += output.mesh.input_id(v) >= 0 ? 1 : 0;
  VtuGrid grid;
  with_team(output.report.threads, [&](const Team& team) { grid = whole_grid(view, team); });
  const VtkHdfSource source{
      output.table,  output.report, view, std::move(grid), view.triangles.nodes_each,
      input_vertices};
  return write_vtkhdf_file(source, path, options.stop, [] { return ok(); });
}

}  // namespace cover
