// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtkhdf_test.cpp.
#include "io/read_mesh/formats/read_vtkhdf_mesh.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "base/faults/errors.hpp"
#include "io/read_mesh/carried_arrays.hpp"
#include "io/read_mesh/formats/mesh_of_data_set.hpp"
#include "io/text/array_names.hpp"
#include "io/vtk_files/arrays/whole_number.hpp"
#include "io/vtk_files/read_vtkhdf.hpp"

namespace cover {
namespace {

using Kind = Hdf5Value::Kind;

/// The field data of one file.
class FieldReaderHdf {
 public:
  explicit FieldReaderHdf(const VtkHdfFile& file) : file_(file) {}

  /// Whole numbers; nothing where there are none.
  [[nodiscard]] std::optional<std::vector<std::int64_t>> numbers(const char* name) const {
    const Hdf5Value* value = file_.field(name, Kind::numbers);
    if (value == nullptr) return std::nullopt;
    return NumberArray(value->type, value->bytes).visit([](auto view) {
      std::vector<std::int64_t> out;
      out.reserve(view.size());
      for (std::size_t k = 0; k < view.size(); ++k)
        out.push_back(whole_number(static_cast<double>(view[k])));
      return out;
    });
  }

  [[nodiscard]] const std::vector<std::string>* texts(const char* name) const {
    const Hdf5Value* value = file_.field(name, Kind::texts);
    return value == nullptr ? nullptr : &value->texts;
  }
  [[nodiscard]] std::string text(const char* name) const {
    const auto* all = texts(name);
    return all == nullptr || all->empty() ? std::string() : all->front();
  }

 private:
  const VtkHdfFile& file_;
};

/// Adds the lines, between points below `points`; false where they do not fit one another.
bool add_lines(const FieldReaderHdf& fields, std::size_t points, MeshCollector& collector) {
  const auto nodes = fields.numbers("LineNodes"), id = fields.numbers("LineID"),
             marker = fields.numbers("LineMarker");
  if (!nodes || !id || !marker || marker->size() != id->size()) return false;
  if (id->empty()) return nodes->empty();
  const std::size_t each = nodes->size() / id->size();
  if (each < 2 || each > 3 || nodes->size() != each * id->size()) return false;
  std::array<std::uint32_t, 3> ends{};
  for (std::size_t l = 0; l < id->size(); ++l) {
    for (std::size_t k = 0; k < each; ++k) {
      const std::int64_t node = (*nodes)[each * l + k];
      if (node < 0 || node >= static_cast<std::int64_t>(points)) return false;
      ends[k] = static_cast<std::uint32_t>(node);
    }
    collector.add_line(std::span(ends).first(each), (*id)[l], static_cast<int>((*marker)[l]));
  }
  return true;
}

/// Adds points with names; false where they do not fit one another.
bool add_points(const FieldReaderHdf& fields, std::size_t points, MeshCollector& collector) {
  const auto* names = fields.texts("PointName");
  const auto vertices = fields.numbers("PointVertex");
  if (names == nullptr && !vertices) return true;
  if (names == nullptr || !vertices || names->size() != vertices->size()) return false;
  for (std::size_t k = 0; k < names->size(); ++k) {
    const std::int64_t v = (*vertices)[k];
    if (v < 0 || v >= static_cast<std::int64_t>(points)) return false;
    collector.mesh.named_points.push_back({VertexId(static_cast<std::uint32_t>(v)), (*names)[k]});
  }
  return true;
}

bool take_regions(const FieldReaderHdf& fields, StoredMesh& stored) {
  const auto* name = fields.texts("RegionName");
  const auto* material_name = fields.texts("MaterialName");
  const auto material = fields.numbers("RegionMaterial");
  if (name == nullptr || material_name == nullptr || !material) return false;
  if (name->size() != material->size() || material_name->size() != material->size()) return false;
  stored.regions.resize(name->size());
  for (std::size_t r = 0; r < name->size(); ++r) {
    Region& region = stored.regions[r];
    region.id = RegionId(r + 1);
    region.name = (*name)[r];
    region.material_name = (*material_name)[r];
    region.material = static_cast<int>((*material)[r]);
  }
  return true;
}

bool take_interfaces(const FieldReaderHdf& fields, StoredMesh& stored) {
  const auto* name = fields.texts("LineName");
  const auto kind = fields.numbers("LineKind"), left = fields.numbers("LeftRegion"),
             right = fields.numbers("RightRegion");
  if (name == nullptr || !kind || !left || !right) return false;
  const std::size_t n = name->size();
  if (kind->size() != n || left->size() != n || right->size() != n) return false;
  const auto regions = static_cast<std::int64_t>(stored.regions.size());
  stored.interfaces.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::int64_t l = (*left)[k], r = (*right)[k], what = (*kind)[k];
    if (l < 0 || l > regions || r < 0 || r > regions || what < 0 || what > 3) return false;
    Interface& line = stored.interfaces[k];
    line.id = InterfaceId(k + 1);
    line.name = (*name)[k];
    line.kind = static_cast<InterfaceKind>(what);
    line.left = RegionId(static_cast<std::uint32_t>(l));
    line.right = RegionId(static_cast<std::uint32_t>(r));
  }
  return true;
}

void take_origin(const VtkHdfFile& file, const FieldReaderHdf& fields, StoredMesh& stored) {
  if (const auto points = fields.numbers("InputVertices"); points && points->size() == 1)
    stored.input_vertices = static_cast<std::size_t>(std::max<std::int64_t>((*points)[0], 0));
  stored.provenance.source = fields.text("Source");
  stored.provenance.version = fields.text("CoverVersion");
  stored.unit = fields.text("Unit");
  const auto* names = fields.texts("OptionName");
  const auto* values = fields.texts("OptionValue");
  for (std::size_t k = 0; names != nullptr && values != nullptr && k < names->size(); ++k)
    if (k < values->size()) stored.provenance.settings.push_back({(*names)[k], (*values)[k]});
  const Hdf5Value* scale = file.field("Scale", Kind::numbers);
  if (scale != nullptr && scale->type == NumberType::float64 &&
      scale->bytes.size() == sizeof(double))
    stored.scale = NumberView<double>(scale->bytes.data(), 1)[0];
}

}  // namespace

Result<VtkHdfMesh> read_vtkhdf_mesh(const std::string& path) {
  const Result<VtkHdfFile> file = read_vtkhdf(path);
  if (!file) return file.error();
  const FieldReaderHdf fields(*file);
  VtkHdfMesh out;
  out.has_names = fields.texts("RegionName") != nullptr;
  bool fits = true;
  Result<MeshFile> mesh = mesh_of(file->data, path, [&](MeshCollector& collector) {
    const std::size_t points = file->data.point_count();
    if (out.has_names)
      fits = add_lines(fields, points, collector) && add_points(fields, points, collector);
  });
  if (!mesh) return std::move(mesh).error();
  out.mesh = std::move(*mesh);
  if (const auto cuts = fields.numbers("CutVertices"); cuts && cuts->size() == 1)
    out.mesh.cut_vertices = static_cast<std::size_t>(std::max<std::int64_t>((*cuts)[0], 0));
  if (!out.has_names) return out;
  if (!fits || !take_regions(fields, out.names) || !take_interfaces(fields, out.names))
    return wrong_file(path, "its names and lines do not fit one another");
  take_origin(*file, fields, out.names);
  if (const auto* order = fields.texts(kArrayOrder)) {
    sort_arrays(*order, out.mesh.arrays);
    sort_arrays(*order, out.mesh.point_arrays);
  }
  for (const CellArray& array : out.mesh.arrays)
    if (const auto* words = fields.texts(words_name(array.name).c_str()))
      out.words.emplace(array.name, *words);
  for (const Interface& line : out.names.interfaces)
    out.mesh.line_names.emplace(line.id.value(), line.name);
  return out;
}

}  // namespace cover
