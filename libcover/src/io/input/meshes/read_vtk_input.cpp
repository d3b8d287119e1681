// A data set becomes a CellMesh, whose borders are the geometry.
// Tested by tests/unit/io/input/meshes/read_vtk_input_test.cpp.
#include <cover/read_vtk_input.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "base/faults/out_of_memory.hpp"
#include "geom/topology/mesh_borders.hpp"
#include "io/images/raster.hpp"
#include "io/images/read_image.hpp"
#include "io/input/formats.hpp"
#include "io/input/meshes/left_out.hpp"
#include "io/text/text.hpp"
#include "io/vtk_files/read_data_set.hpp"

namespace cover {
namespace {

// In lower case; the first that is there counts.
constexpr std::array kMaterialArrays{
    "material", "materialid",  "mat_id",     "gmsh:physical", "medit:ref", "cellentityids",
    "regionid", "materialids", "materials",  "material_id",   "matid",     "mat",
    "phase",    "attribute",   "attributes", "region",        "region_id", "physical"};
constexpr std::array kLineArrays{"lineid", "gmsh:physical", "medit:ref"};

using Nodes = std::span<const std::uint32_t>;

/// A cell array that has a name: its numbers, where there is a whole one for each cell.
struct NamedArray {
  std::string name;
  std::optional<std::vector<int>> integers;
};

/// The numbers of an array, if there is one for each cell and an int holds it.
std::optional<std::vector<int>> as_integers(const NumberArray& array, std::size_t cells) {
  if (!array.is_one_per(cells)) return std::nullopt;
  return array.visit([&](auto numbers) -> std::optional<std::vector<int>> {
    std::vector<int> integers(cells);
    for (std::size_t c = 0; c < cells; ++c) {
      const auto value = static_cast<double>(numbers[c]);
      if (!(std::abs(value) <= std::numeric_limits<int>::max()) || value != std::floor(value))
        return std::nullopt;
      integers[c] = static_cast<int>(value);
    }
    return integers;
  });
}

std::vector<NamedArray> named_arrays(const std::vector<NumberArray>& arrays, std::size_t count) {
  std::vector<NamedArray> out;
  for (const NumberArray& array : arrays) out.push_back({array.name, as_integers(array, count)});
  return out;
}

/// The first array of integers that has one of the names, in whatever case.
template <class Names>
const std::vector<int>* first_of(const std::vector<NamedArray>& arrays, const Names& names) {
  for (const char* name : names) {
    for (const NamedArray& a : arrays)
      if (a.integers && lower(a.name) == name) return &*a.integers;
  }
  return nullptr;
}

/// The array of integers, where there is exactly one.
const std::vector<int>* only_array(const std::vector<NamedArray>& arrays) {
  const auto is_it = [](const NamedArray& a) { return a.integers.has_value(); };
  if (std::count_if(arrays.begin(), arrays.end(), is_it) != 1) return nullptr;
  return &*std::find_if(arrays.begin(), arrays.end(), is_it)->integers;
}

/// The materials among arrays; else nullptr.
const std::vector<int>* materials_in(const std::vector<NamedArray>& arrays) {
  const std::vector<int>* const named = first_of(arrays, kMaterialArrays);
  return named != nullptr ? named : only_array(arrays);
}

/// The cells of a data set as a CellMesh.
class CellsOfDataSet {
 public:
  CellsOfDataSet(const DataSet& data, const std::string& source)
      : data_(data), arrays_(named_arrays(data.cell_arrays, data.cell_count())) {
    mesh_.source = source;
    material_ = materials_in(arrays_);
    line_ = first_of(arrays_, kLineArrays);
  }

  /// The cells as pixels of a picture, where they are pixels and have materials.
  [[nodiscard]] std::optional<Raster> picture() const {
    const std::optional<DataSet::Pixels> pixels = data_.pixels();
    if (!pixels || !material_) return std::nullopt;
    return raster_of(*pixels, *material_);
  }

  /// The points of a lattice as the middles of pixels, where points have materials and cells none.
  [[nodiscard]] std::optional<Raster> picture_of_points() const {
    std::optional<DataSet::Pixels> pixels = data_.pixels();
    if (!pixels || material_) return std::nullopt;
    const std::vector<NamedArray> arrays = named_arrays(data_.point_arrays, data_.point_count());
    const std::vector<int>* const material = materials_in(arrays);
    if (material == nullptr) return std::nullopt;
    const auto grow = [](std::size_t& cells, double& first, double& last) {
      const double half = (last - first) / static_cast<double>(2 * cells);
      first -= half;
      last += half;
      ++cells;
    };
    grow(pixels->width, pixels->first[0], pixels->last[0]);
    grow(pixels->height, pixels->first[1], pixels->last[1]);
    return raster_of(*pixels, *material);
  }
  Result<CellMesh> convert() {
    if (std::optional<Error> error = read_points()) return *error;
    std::array<std::uint32_t, 8> room{};
    for (std::size_t c = 0; c < data_.cell_count(); ++c)
      if (std::optional<Error> error = read_cell(c, data_.nodes(c, room))) return *error;
    if (mesh_.cells() == 0 && mesh_.lines.empty())
      return error(ErrorCode::syntax, "no polygons and no lines in it");
    return std::move(mesh_);
  }

  /// How many cells convert() took the corners of alone.
  [[nodiscard]] std::size_t second_order() const { return second_order_; }

 private:
  static std::optional<Raster> raster_of(const DataSet::Pixels& pixels,
                                         const std::vector<int>& labels) {
    const double width = pixels.last[0] - pixels.first[0],
                 height = pixels.last[1] - pixels.first[1];
    if (!std::isfinite(width) || !std::isfinite(height) || width == 0 || height == 0)
      return std::nullopt;
    Raster raster;
    raster.width = pixels.width;
    raster.height = pixels.height;
    raster.is_signed = true;
    raster.corner = {pixels.first[0], pixels.first[1]};
    raster.pixel_width = width / static_cast<double>(raster.width);
    raster.pixel_height = height / static_cast<double>(raster.height);
    for (const int label : labels)
      raster.pixels.push_back(static_cast<std::uint64_t>(std::int64_t{label}));
    return raster;
  }

  [[nodiscard]] Error error(ErrorCode code, const std::string& what) const {
    return {code, fmt::format("{}: {}", mesh_.source, what), {}, {}};
  }

  std::optional<Error> read_points() {
    const std::size_t count = data_.point_count();
    mesh_.points.reserve(count);
    mesh_.point_ids.reserve(count);
    for (std::size_t p = 0; p < count; ++p) {
      const DataSet::Coordinates x = data_.point(p);
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]))
        return error(ErrorCode::non_finite_coordinate, fmt::format("point {} is not finite", p));
      mesh_.points.push_back({x[0], x[1]});
      mesh_.point_ids.push_back(static_cast<long>(p));
    }
    if (const Status plane = data_.check_plane(); !plane)
      return error(plane.error().code, plane.error().message);
    return std::nullopt;
  }

  std::optional<Error> read_cell(std::size_t c, Nodes nodes) {
    using namespace cell_type;
    switch (data_.type(c)) {
      case kEmpty:
      case kVertex:
      case kPolyVertex:
        return std::nullopt;
      case kLine:
      case kPolyLine:
        add_lines(c, nodes);
        return std::nullopt;
      case kQuadraticEdge:
        ++second_order_;
        add_lines(c, nodes.first(2));
        return std::nullopt;
      case kQuadraticTriangle:
        ++second_order_;
        return add_cell(c, nodes.first(3));
      case kTriangle:
        return add_cell(c, nodes.first(3));
      case kQuadraticQuad:
      case kBiquadraticQuad:
        ++second_order_;
        return add_cell(c, nodes.first(4));
      case kQuad:
        return add_cell(c, nodes.first(4));
      case kPixel:
        return add_cell(c, std::array{nodes[0], nodes[1], nodes[3], nodes[2]});
      case kTriangleStrip:
        for (std::size_t k = 2; k < nodes.size(); ++k)
          if (auto failed = add_cell(c, nodes.subspan(k - 2, 3))) return failed;
        return std::nullopt;
      case kPolygon:
        return add_cell(c, nodes);
      default:
        return error(ErrorCode::unsupported_format,
                     fmt::format("cell {} is of VTK's type {}; plane meshes of triangles, "
                                 "quadrangles and polygons are read",
                                 c, data_.type(c)));
    }
  }

  void add_lines(std::size_t c, Nodes nodes) {
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      CellMesh::Line line;
      line.a = nodes[k];
      line.b = nodes[k + 1];
      line.id = static_cast<long>(c);
      const int number = line_ ? (*line_)[c] : 0;
      if (number > 0) {
        line.marker = number;
        line.name = std::to_string(number);
      }
      mesh_.lines.push_back(std::move(line));
    }
  }

  std::optional<Error> add_cell(std::size_t c, Nodes corners) {
    if (!material_) return error(ErrorCode::syntax, no_material());
    if (corners.size() < 3) return std::nullopt;
    const auto [at, is_new] =
        index_.emplace((*material_)[c], static_cast<std::uint32_t>(mesh_.materials.size()));
    if (is_new) mesh_.materials.push_back(std::to_string(at->first));
    corners_.assign(corners.begin(), corners.end());
    mesh_.add_cell(corners_, at->second);
    return std::nullopt;
  }

  [[nodiscard]] std::string no_material() const {
    std::string names;
    for (const NamedArray& a : arrays_) {
      names += (names.empty() ? "" : ", ") + a.name;
      if (!a.integers) names += " (no whole numbers)";
    }
    return "no cell array of whole numbers called material (or MaterialID, mat_id, ...); " +
           (names.empty() ? "there are no cell arrays" : "the cell arrays are " + names);
  }

  const DataSet& data_;
  std::vector<NamedArray> arrays_;
  const std::vector<int>* material_ = nullptr;
  const std::vector<int>* line_ = nullptr;
  std::map<int, std::uint32_t> index_;
  std::vector<std::uint32_t> corners_;
  std::size_t second_order_ = 0;
  CellMesh mesh_;
};

}  // namespace

Result<Input> parse_vtk_input(std::string_view text, std::string_view extension,
                              const std::string& source, const ImageOptions* image) {
  const Result<DataSet> data = parse_data_set(text, extension, source);
  if (!data) return data.error();
  CellsOfDataSet converter(*data, source);
  if (image != nullptr) {
    if (const std::optional<Raster> picture = converter.picture())
      return input_of(*picture, source, *image);
  }
  if (const std::optional<Raster> picture = converter.picture_of_points()) {
    ImageOptions sides_of_pixels;
    sides_of_pixels.smooth = false;
    return input_of(*picture, source, image != nullptr ? *image : sides_of_pixels);
  }
  Result<CellMesh> mesh = converter.convert();
  if (!mesh) return std::move(mesh).error();
  Input input = borders_of(*mesh);
  if (converter.second_order() > 0)
    input.warnings.push_back(corners_taken(converter.second_order()));
  if (data->array_of_points("PeriodicNode") != nullptr)
    input.warnings.push_back(pairs_left_out("PeriodicNode"));
  if (data->array_of_cells("RegionId") != nullptr) input.warnings.push_back(names_left_out());
  for (std::string& warning : values_left_out(data->point_arrays))
    input.warnings.push_back(std::move(warning));
  return input;
}

Result<Input> read_vtk_input(const std::string& path) {
  return memory_as_value(path, [&]() -> Result<Input> {
    const std::string extension = extension_of(path);
    if (!is_data_set(extension)) return parse_vtk_input({}, extension, path);
    const Result<std::string> text = read_file(path);
    if (!text) return text.error();
    return parse_vtk_input(*text, extension, path);
  });
}

}  // namespace cover
