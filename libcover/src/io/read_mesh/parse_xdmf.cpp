// Numbers stand in the leaves of the XML. VTK's own XDMF reader was left alone from the start: it
// brings HDF5 along and crashes on broken files. Tested by
// tests/unit/vtk/read_output_test.cpp.
#include <type_traits>
#include <utility>

#include <fmt/core.h>

#include "io/read_mesh/mesh_collector.hpp"
#include "io/read_mesh/mesh_formats.hpp"
#include "io/text/text.hpp"
#include "io/text/token_reader.hpp"
#include "io/text/xml_tree.hpp"

namespace cover {
namespace {

class XdmfReader {
 public:
  XdmfReader(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  Result<MeshFile> read() {
    const Result<XmlTree> tree = parse_xml(text_, path_);
    if (!tree) return tree.error();
    const XmlElement* domain = tree->root.child("Domain");
    const XmlElement* triangles = domain == nullptr ? nullptr : domain->child("Grid", "mesh");
    if (triangles == nullptr) return wrong("there is no grid 'mesh': not written by cover");
    if (Status status = read_triangles(*triangles); !status) return std::move(status).error();
    if (const XmlElement* lines = domain->child("Grid", "lines")) {
      if (Status status = read_lines(*lines); !status) return std::move(status).error();
    }
    return collector_.finish();
  }

 private:
  [[nodiscard]] Error wrong(std::string_view what) const {
    return {ErrorCode::syntax, fmt::format("{}: {}", path_, what), {}, {}};
  }

  /// The text of the data item inside `parent`.
  Result<std::string_view> data_in(const XmlElement* parent) const {
    const XmlElement* item = parent == nullptr ? nullptr : parent->child("DataItem");
    if (item == nullptr) return wrong("a data item is missing");
    if (item->value("Format") != "XML")
      return Error{ErrorCode::unsupported_format,
                   fmt::format("{}: numbers outside the XML are not read", path_),
                   {},
                   {}};
    return item->text;
  }

  /// All numbers of an item. `Number` is long or double.
  template <class Number>
  Result<std::vector<Number>> numbers_in(const XmlElement* parent) const {
    const Result<std::string_view> text = data_in(parent);
    if (!text) return text.error();
    TokenReader tokens(*text, path_);
    std::vector<Number> numbers;
    // The number of items is not known before: a word that is none ends it.
    while (!tokens.failed() && !tokens.at_end()) {
      if constexpr (std::is_same_v<Number, double>) {
        numbers.push_back(tokens.real("a coordinate"));
      } else {
        numbers.push_back(tokens.integer("an integer"));
      }
    }
    if (tokens.failed()) return tokens.error();
    return numbers;
  }

  Status read_triangles(const XmlElement& grid) {
    auto coordinates = numbers_in<double>(grid.child("Geometry"));
    if (!coordinates) return std::move(coordinates).error();
    for (std::size_t k = 0; k + 1 < coordinates->size(); k += 2)
      collector_.mesh.soup.points.push_back({(*coordinates)[k], (*coordinates)[k + 1]});
    const auto cells = cells_of(grid, 3);
    if (!cells) return cells.error();
    for (const auto& cell : *cells) collector_.add_triangle(cell);
    TriangleSoup& soup = collector_.mesh.soup;
    for (const auto& [name, values] : {std::pair{"MaterialID", &soup.material},
                                       {"RegionId", &soup.region},
                                       {"GroupID", &collector_.mesh.group}}) {
      const XmlElement* array = grid.child("Attribute", name);
      if (array == nullptr) continue;
      auto numbers = numbers_in<long>(array);
      if (!numbers) return std::move(numbers).error();
      if (numbers->size() != cells->size()) return wrong(fmt::format("{}: wrong size", name));
      values->assign(numbers->begin(), numbers->end());
    }
    collector_.mesh.region_names = names_of(grid);
    return ok();
  }

  Status read_lines(const XmlElement& grid) {
    const auto cells = cells_of(grid, 2);
    if (!cells) return cells.error();
    auto groups = numbers_in<long>(grid.child("Attribute", "LineID"));
    if (!groups) return std::move(groups).error();
    auto markers = numbers_in<long>(grid.child("Attribute", "Marker"));
    if (!markers) return std::move(markers).error();
    if (groups->size() != cells->size() || markers->size() != cells->size())
      return wrong("arrays of lines have the wrong size");
    for (std::size_t l = 0; l < cells->size(); ++l)
      collector_.add_line((*cells)[l], (*groups)[l], static_cast<int>((*markers)[l]));
    collector_.mesh.line_names = names_of(grid);
    return ok();
  }

  /// The nodes of each cell, of which each has `corners` corners and maybe midpoints.
  Result<std::vector<std::vector<std::uint32_t>>> cells_of(const XmlElement& grid,
                                                           std::size_t corners) const {
    const XmlElement* topology = grid.child("Topology");
    const auto nodes = numbers_in<long>(topology);
    if (!nodes) return nodes.error();
    const std::size_t each = topology->value("NodesPerElement") == std::to_string(corners)
                                 ? corners
                                 : 2 * corners - (corners == 2 ? 1 : 0);
    if (nodes->size() % each != 0) return wrong("a grid with other cells than triangles or lines");
    std::vector<std::vector<std::uint32_t>> cells(nodes->size() / each);
    const auto points = static_cast<long>(collector_.mesh.soup.points.size());
    for (std::size_t k = 0; k < nodes->size(); ++k) {
      const long node = (*nodes)[k];
      if (node < 0 || node >= points)
        return Error{ErrorCode::id_out_of_range,
                     fmt::format("{}: a cell has the node {} of {}", path_, node, points),
                     {},
                     {}};
      cells[k / each].push_back(static_cast<std::uint32_t>(node));
    }
    return cells;
  }

  /// The names of groups, by number.
  static std::map<std::int64_t, std::string> names_of(const XmlElement& grid) {
    std::map<std::int64_t, std::string> names;
    for (const XmlElement& child : grid.children) {
      if (child.name != "Information") continue;
      if (const auto number = parse_integer(child.value("Value")))
        names.emplace(*number, child.value("Name"));
    }
    return names;
  }

  std::string_view text_;
  const std::string& path_;
  MeshCollector collector_;
};

}  // namespace

Result<MeshFile> parse_xdmf(std::string_view text, const std::string& source) {
  return XdmfReader(text, source).read();
}

}  // namespace cover
