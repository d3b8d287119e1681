// VTK's XML parser makes a tree; numbers stand in its leaves. Its own XDMF reader is left alone: it
// brings HDF5 along and crashes on broken files. Tested by tests/unit/vtk/read_output_test.cpp.
#include "vtk/read_xdmf.hpp"

#include <cstring>
#include <filesystem>
#include <type_traits>
#include <utility>

#include <fmt/core.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include "io/read_mesh/mesh_collector.hpp"
#include "io/text/text.hpp"
#include "io/text/token_reader.hpp"
#include "vtk/quiet_vtk.hpp"

namespace cover {
namespace {

using Element = vtkXMLDataElement;

std::string attribute(Element& element, const char* name) {
  const char* value = element.GetAttribute(name);
  return value == nullptr ? "" : value;
}

/// The nested element called `tag` whose attribute Name is `name` (any if nullptr), or nullptr.
Element* find(Element& parent, const char* tag, const char* name = nullptr) {
  for (int k = 0; k < parent.GetNumberOfNestedElements(); ++k) {
    Element* child = parent.GetNestedElement(k);
    if (std::strcmp(child->GetName(), tag) != 0) continue;
    if (name == nullptr || attribute(*child, "Name") == name) return child;
  }
  return nullptr;
}

class XdmfReader {
 public:
  explicit XdmfReader(const std::string& path) : path_(path) {}

  Result<MeshFile> read() {
    const QuietVtk quiet;
    const auto root =
        vtkSmartPointer<Element>::Take(vtkXMLUtilities::ReadElementFromFile(path_.c_str()));
    if (!root) return wrong("not valid XML");
    Element* domain = find(*root, "Domain");
    Element* triangles = domain == nullptr ? nullptr : find(*domain, "Grid", "mesh");
    if (triangles == nullptr) return wrong("there is no grid 'mesh': not written by cover");
    if (Status status = read_triangles(*triangles); !status) return std::move(status).error();
    if (Element* lines = find(*domain, "Grid", "lines")) {
      if (Status status = read_lines(*lines); !status) return std::move(status).error();
    }
    return collector_.finish();
  }

 private:
  [[nodiscard]] Error wrong(std::string_view what) const {
    return {ErrorCode::syntax, fmt::format("{}: {}", path_, what), {}, {}};
  }

  /// The text of the data item inside `parent`.
  Result<std::string_view> data_in(Element* parent) const {
    Element* item = parent == nullptr ? nullptr : find(*parent, "DataItem");
    if (item == nullptr) return wrong("a data item is missing");
    if (attribute(*item, "Format") != "XML")
      return Error{ErrorCode::unsupported_format,
                   fmt::format("{}: numbers outside the XML are not read", path_),
                   {},
                   {}};
    const char* text = item->GetCharacterData();
    return std::string_view(text == nullptr ? "" : text);
  }

  /// All numbers of an item. `Number` is long or double.
  template <class Number>
  Result<std::vector<Number>> numbers_in(Element* parent) const {
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

  Status read_triangles(Element& grid) {
    auto coordinates = numbers_in<double>(find(grid, "Geometry"));
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
      Element* array = find(grid, "Attribute", name);
      if (array == nullptr) continue;
      auto numbers = numbers_in<long>(array);
      if (!numbers) return std::move(numbers).error();
      if (numbers->size() != cells->size()) return wrong(fmt::format("{}: wrong size", name));
      values->assign(numbers->begin(), numbers->end());
    }
    collector_.mesh.region_names = names_of(grid);
    return ok();
  }

  Status read_lines(Element& grid) {
    const auto cells = cells_of(grid, 2);
    if (!cells) return cells.error();
    auto groups = numbers_in<long>(find(grid, "Attribute", "LineID"));
    if (!groups) return std::move(groups).error();
    auto markers = numbers_in<long>(find(grid, "Attribute", "Marker"));
    if (!markers) return std::move(markers).error();
    if (groups->size() != cells->size() || markers->size() != cells->size())
      return wrong("arrays of lines have the wrong size");
    for (std::size_t l = 0; l < cells->size(); ++l)
      collector_.add_line((*cells)[l], (*groups)[l], static_cast<int>((*markers)[l]));
    collector_.mesh.line_names = names_of(grid);
    return ok();
  }

  /// The nodes of each cell, of which each has `corners` corners and maybe midpoints.
  Result<std::vector<std::vector<std::uint32_t>>> cells_of(Element& grid,
                                                           std::size_t corners) const {
    Element* topology = find(grid, "Topology");
    const auto nodes = numbers_in<long>(topology);
    if (!nodes) return nodes.error();
    const std::size_t each = attribute(*topology, "NodesPerElement") == std::to_string(corners)
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
  static std::map<std::int64_t, std::string> names_of(Element& grid) {
    std::map<std::int64_t, std::string> names;
    for (int k = 0; k < grid.GetNumberOfNestedElements(); ++k) {
      Element* child = grid.GetNestedElement(k);
      if (std::strcmp(child->GetName(), "Information") != 0) continue;
      if (const auto number = parse_integer(attribute(*child, "Value")))
        names.emplace(*number, attribute(*child, "Name"));
    }
    return names;
  }

  std::string path_;
  MeshCollector collector_;
};

}  // namespace

Result<MeshFile> read_xdmf(const std::string& path) {
  if (!std::filesystem::is_regular_file(path))
    return Error{ErrorCode::cannot_open, fmt::format("cannot open '{}'", path), {}, {}};
  return XdmfReader(path).read();
}

}  // namespace cover
