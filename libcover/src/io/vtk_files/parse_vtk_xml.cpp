// Pieces are put together as they come; most files have one.
// Tested by tests/unit/io/vtk_files/read_data_set_test.cpp.
#include <array>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include "base/faults/errors.hpp"
#include "io/text/limits.hpp"
#include "io/text/text.hpp"
#include "io/text/xml_tree.hpp"
#include "io/vtk_files/arrays/array_reader.hpp"
#include "io/vtk_files/arrays/ascii_numbers.hpp"
#include "io/vtk_files/parse_data_set.hpp"

namespace cover {
namespace {

class XmlDataSetParser {
 public:
  XmlDataSetParser(std::string_view text, const std::string& source)
      : text_(text), source_(source) {}

  Result<DataSet> parse() {
    Result<XmlTree> tree = parse_xml(text_, source_, "AppendedData");
    if (!tree) return std::move(tree).error();
    if (tree->root.name != "VTKFile") return wrong("no file of VTK: its root is no <VTKFile>");
    Result<ArrayReader> arrays = ArrayReader::create(text_, *tree, source_);
    if (!arrays) return std::move(arrays).error();
    arrays_ = &*arrays;
    for (const char* kind : {"UnstructuredGrid", "PolyData", "ImageData"}) {
      const XmlElement* element = tree->root.child(kind);
      if (element == nullptr) continue;
      Status status = read_pieces(*element, kind);
      if (!status) return std::move(status).error();
      data_.cut_vertices = cut_vertices_of(*element);
      return std::move(data_);
    }
    const std::string* type = tree->root.attribute("type");
    return Error{ErrorCode::unsupported_format,
                 fmt::format("{}: VTK's type '{}' is not read: UnstructuredGrid, PolyData and "
                             "ImageData are",
                             source_, legible(type == nullptr ? std::string_view() : *type)),
                 {},
                 {}};
  }

 private:
  [[nodiscard]] Error error(ErrorCode code, std::string_view what) const {
    return {code, fmt::format("{}: {}", source_, what), {}, {}};
  }
  [[nodiscard]] Error wrong(std::string_view what) const { return error(ErrorCode::syntax, what); }

  /// A count that an element has as an attribute; 0 where it has none.
  Result<std::size_t> count(const XmlElement& element, const char* name) const {
    const std::string* text = element.attribute(name);
    if (text == nullptr) return std::size_t{0};
    const auto number = parse_integer(*text);
    if (!number || *number < 0)
      return wrong(fmt::format("{}=\"{}\" is no count", name, legible(*text)));
    return static_cast<std::size_t>(*number);
  }

  /// Zero where no field data tells.
  static std::size_t cut_vertices_of(const XmlElement& element) {
    const XmlElement* field = element.child("FieldData");
    const XmlElement* array = field == nullptr ? nullptr : field->child("DataArray", "CutVertices");
    const auto number = array == nullptr ? std::nullopt : parse_integer(array->text);
    return number && *number > 0 ? static_cast<std::size_t>(*number) : 0;
  }

  Status read_pieces(const XmlElement& element, std::string_view kind) {
    std::vector<std::vector<NumberArray>> of_points, of_cells;
    std::size_t pieces = 0;
    for (const XmlElement& piece : element.children) {
      if (piece.name != "Piece") continue;
      if (kind == "ImageData" && pieces > 0) return wrong("images in pieces are not read");
      ++pieces;
      const std::size_t points = data_.point_count(), cells = data_.cell_count();
      points_before_ = points;
      Status status = kind == "UnstructuredGrid" ? read_grid(piece)
                      : kind == "PolyData"       ? read_surface(piece)
                                                 : read_image(element, piece);
      if (status)
        status = read_arrays(piece.child("PointData"), data_.point_count() - points, of_points);
      if (status)
        status = read_arrays(piece.child("CellData"), data_.cell_count() - cells, of_cells);
      if (!status) return status;
    }
    if (pieces == 0) return wrong("there is no <Piece> in it");
    data_.point_arrays = join_pieces(std::move(of_points));
    data_.cell_arrays = join_pieces(std::move(of_cells));
    return ok();
  }

  Status read_points(const XmlElement& piece) {
    const auto points = count(piece, "NumberOfPoints");
    if (!points) return points.error();
    const XmlElement* element = piece.child("Points");
    const XmlElement* array = element == nullptr ? nullptr : element->child("DataArray");
    if (*points == 0) return ok();
    if (array == nullptr) return wrong("a piece has points, but no coordinates of them");
    const auto components = arrays_->components(*array);
    if (!components) return components.error();
    if (*components != 3)
      return wrong(fmt::format("points have {} coordinates and not 3", *components));
    const auto coordinates = arrays_->read(*array, *points);
    if (!coordinates) return coordinates.error();
    Status status = data_.add_points(*coordinates);
    return status ? ok() : Status(in_file(source_, std::move(status).error()));
  }

  /// An array with one number for each of `items`, of the cells in `element`.
  Result<NumberArray> cell_numbers(const XmlElement* element, std::string_view name,
                                   std::size_t items) const {
    const XmlElement* array = element == nullptr ? nullptr : element->child("DataArray", name);
    if (array == nullptr) return wrong(fmt::format("the cells have no array '{}'", name));
    const auto components = arrays_->components(*array);
    if (!components) return components.error();
    if (*components != 1)
      return wrong(fmt::format("the array '{}' of the cells is not one of numbers", name));
    return arrays_->read(*array, items);
  }

  Status add_cells(const XmlElement* element, const std::vector<std::size_t>& offsets,
                   std::vector<std::uint8_t> types) {
    const auto nodes = cell_numbers(element, "connectivity", offsets.back());
    if (!nodes) return nodes.error();
    Status status = data_.add_cells(*nodes, offsets, std::move(types), points_before_);
    return status ? ok() : Status(in_file(source_, std::move(status).error()));
  }

  Result<std::vector<std::size_t>> offsets_of(const XmlElement* element, std::size_t cells) const {
    const auto numbers = cell_numbers(element, "offsets", cells);
    if (!numbers) return numbers.error();
    auto offsets = as_offsets(*numbers, true);
    if (!offsets) return in_file(source_, std::move(offsets).error());
    return offsets;
  }

  Status read_grid(const XmlElement& piece) {
    if (Status status = read_points(piece); !status) return status;
    const auto cells = count(piece, "NumberOfCells");
    if (!cells) return cells.error();
    if (*cells == 0) return ok();
    const XmlElement* element = piece.child("Cells");
    const auto offsets = offsets_of(element, *cells);
    if (!offsets) return offsets.error();
    const auto numbers = cell_numbers(element, "types", *cells);
    if (!numbers) return numbers.error();
    auto types = as_cell_types(*numbers);
    if (!types) return in_file(source_, std::move(types).error());
    return add_cells(element, *offsets, std::move(*types));
  }

  Status read_surface(const XmlElement& piece) {
    if (Status status = read_points(piece); !status) return status;
    for (std::size_t kind = 0; kind < kSurfaceCells.size(); ++kind) {
      const auto cells = count(piece, kSurfaceCells[kind].count);
      if (!cells) return cells.error();
      if (*cells == 0) continue;
      const XmlElement* element = piece.child(kSurfaceCells[kind].element);
      const auto offsets = offsets_of(element, *cells);
      if (!offsets) return offsets.error();
      auto types = surface_types(kind, *offsets);
      if (!types) return in_file(source_, std::move(types).error());
      if (Status status = add_cells(element, *offsets, std::move(*types)); !status) return status;
    }
    return ok();
  }

  /// The numbers of an attribute; `otherwise` where it is not there.
  template <class T, std::size_t n>
  Result<std::array<T, n>> numbers(const XmlElement& element, const char* name,
                                   std::array<T, n> otherwise) const {
    const std::string* text = element.attribute(name);
    if (text == nullptr) return otherwise;
    std::string_view rest = *text;
    if (read_ascii(rest, otherwise.data(), n) != n || !rest.empty())
      return wrong(fmt::format("{}=\"{}\" is not {} numbers", name, legible(*text), n));
    return otherwise;
  }

  Status read_image(const XmlElement& image, const XmlElement& piece) {
    const auto whole = numbers(image, "WholeExtent", std::array<std::int32_t, 6>{});
    if (!whole) return whole.error();
    const auto extent = numbers(piece, "Extent", *whole);
    if (!extent) return extent.error();
    const auto origin = numbers(image, "Origin", std::array<double, 3>{0, 0, 0});
    if (!origin) return origin.error();
    const auto spacing = numbers(image, "Spacing", std::array<double, 3>{1, 1, 1});
    if (!spacing) return spacing.error();
    constexpr std::array<double, 9> kUpright{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const auto direction = numbers(image, "Direction", kUpright);
    if (!direction) return direction.error();
    if (*direction != kUpright)
      return error(ErrorCode::unsupported_format, "images that are turned are not read");
    std::array<std::size_t, 3> dimensions{};
    std::array<std::vector<double>, 3> axes;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t low = (*extent)[2 * k], high = (*extent)[2 * k + 1];
      if (high < low) return wrong("an extent without points");
      dimensions[k] = static_cast<std::size_t>(high - low + 1);
    }
    if (Status status = check_lattice(dimensions, text_.size()); !status)
      return in_file(source_, std::move(status).error());
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < dimensions[k]; ++i)
        axes[k].push_back((*origin)[k] +
                          (*spacing)[k] * ((*extent)[2 * k] + static_cast<double>(i)));
    data_.set_lattice(dimensions, std::move(axes));
    data_.set_even();
    return ok();
  }

  /// Adds the arrays of a piece with `items` items to those of other pieces.
  Status read_arrays(const XmlElement* element, std::size_t items,
                     std::vector<std::vector<NumberArray>>& pieces) const {
    if (items == 0) return ok();
    std::vector<NumberArray>& arrays = pieces.emplace_back();
    if (element == nullptr) return ok();
    for (const XmlElement& array : element->children) {
      const std::string* name = array.attribute("Name");
      if (name == nullptr || (array.name != "DataArray" && array.name != "Array")) continue;
      const auto components = arrays_->components(array);
      if (!components) return components.error();
      NumberArray numbers;
      if (*components == 1) {
        Result<NumberArray> read = arrays_->read(array, items);
        if (!read) return std::move(read).error();
        numbers = std::move(*read);
      }
      numbers.name = *name;
      numbers.components = *components;
      arrays.push_back(std::move(numbers));
    }
    return ok();
  }

  std::string_view text_;
  const std::string& source_;
  ArrayReader* arrays_ = nullptr;
  DataSet data_;
  std::size_t points_before_ = 0;
};

}  // namespace

Result<DataSet> parse_vtk_xml(std::string_view text, const std::string& source) {
  return XmlDataSetParser(text, source).parse();
}

}  // namespace cover
