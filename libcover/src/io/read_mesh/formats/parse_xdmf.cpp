// Numbers stand in the leaves of the XML, or in an HDF5 file beside it. VTK's own XDMF reader was
// left alone from the start: it crashes on broken files.
#include <filesystem>
#include <memory>
#include <set>
#include <type_traits>
#include <utility>

#include <fmt/core.h>

#include "base/content_hash.hpp"
#include "base/numbers.hpp"
#include "io/hdf5/parse_hdf5.hpp"
#include "io/read_mesh/mesh_collector.hpp"
#include "io/read_mesh/mesh_formats.hpp"
#include "io/text/array_names.hpp"
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
    if (const XmlElement* hash = domain->child("Information", kXdmfHash))
      hash_ = hash->value("Value");
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

  [[nodiscard]] Error unsupported(std::string_view what) const {
    return {ErrorCode::unsupported_format, fmt::format("{}: {}", path_, what), {}, {}};
  }

  /// Which numbers an array may hold: values are finite or none (NaN), and may be stored whole.
  enum class Kind { whole, coordinates, values };

  /// All numbers of the item inside `parent`.
  template <Kind kKind>
  auto numbers_in(const XmlElement* parent)
      -> Result<std::vector<std::conditional_t<kKind == Kind::whole, long, double>>> {
    const XmlElement* item = parent == nullptr ? nullptr : parent->child("DataItem");
    if (item == nullptr) return wrong("a data item is missing");
    if (item->value("Format") == "HDF") return heavy_numbers<kKind>(item->text);
    if (item->value("Format") != "XML")
      return unsupported("numbers are read from the XML or from HDF5 beside it");
    TokenReader tokens(item->text, path_);
    std::vector<std::conditional_t<kKind == Kind::whole, long, double>> numbers;
    // The number of items is not known before: a word that is none ends it.
    while (!tokens.failed() && !tokens.at_end()) {
      if constexpr (kKind == Kind::values) {
        numbers.push_back(parse_double(tokens.word()).value_or(kNoNumber));
      } else if constexpr (kKind == Kind::coordinates) {
        numbers.push_back(tokens.real("a coordinate"));
      } else {
        numbers.push_back(tokens.integer("an integer"));
      }
    }
    if (tokens.failed()) return tokens.error();
    return numbers;
  }

  /// The numbers of `place`, as "X.h5:/mesh/topology".
  template <Kind kKind>
  auto heavy_numbers(std::string_view place)
      -> Result<std::vector<std::conditional_t<kKind == Kind::whole, long, double>>> {
    using Number = std::conditional_t<kKind == Kind::whole, long, double>;
    const std::size_t colon = place.rfind(':');
    if (colon == place.npos) return wrong("an item in HDF5 names no array");
    const std::string file = without_references(place.substr(0, colon));
    if (file != std::filesystem::path(file).filename())
      return unsupported("numbers in HDF5 are read from a file beside the XML only");
    if (Status status = open_heavy(file); !status) return std::move(status).error();
    const auto found = heavy_.find(place.substr(colon + 1));
    if (found == heavy_.end() || found->second.value.kind != Hdf5Value::Kind::numbers)
      return wrong(fmt::format("{} holds no numbers that are read", place));
    const Hdf5Value& value = found->second.value;
    return with_type(value.type, [&](auto number) -> Result<std::vector<Number>> {
      using Stored = decltype(number);
      if constexpr (kKind != Kind::values &&
                    std::is_floating_point_v<Stored> != std::is_floating_point_v<Number>) {
        return wrong(fmt::format("{} holds numbers of another kind", place));
      } else {
        const NumberView<Stored> stored(value.bytes.data(), value.bytes.size() / sizeof(Stored));
        std::vector<Number> numbers(stored.size());
        for (std::size_t k = 0; k < numbers.size(); ++k)
          numbers[k] = static_cast<Number>(stored[k]);  // NOLINT(bugprone-signed-char-misuse)
        return numbers;
      }
    });
  }

  /// One file holds all.
  Status open_heavy(const std::string& file) {
    if (heavy_text_ != nullptr && heavy_name_ == file) return ok();
    const std::string path =
        (std::filesystem::path(path_).parent_path() / file).lexically_normal().string();
    Result<std::string> text = read_file(path);
    if (!text) return std::move(text).error();
    heavy_.clear();
    heavy_text_ = std::make_unique<const std::string>(*std::move(text));
    heavy_name_ = file;
    ContentHash hash;
    hash.add(*heavy_text_);
    Result<Hdf5Tree> tree = parse_hdf5(*heavy_text_, path);
    if (!tree) return std::move(tree).error();
    if (!hash_.empty() && hash_ != hash.text())
      return wrong(
          fmt::format("{} holds the numbers of another mesh, or is damaged: both files "
                      "must be of one run, as it wrote them",
                      path));
    heavy_ = *std::move(tree);
    return ok();
  }

  Status read_triangles(const XmlElement& grid) {
    auto coordinates = numbers_in<Kind::coordinates>(grid.child("Geometry"));
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
      auto numbers = numbers_in<Kind::whole>(array);
      if (!numbers) return std::move(numbers).error();
      if (numbers->size() != cells->size()) return wrong(fmt::format("{}: wrong size", name));
      values->assign(numbers->begin(), numbers->end());
    }
    collector_.mesh.region_names = names_of(grid);
    return read_arrays(grid);
  }

  /// Numbers of triangles and points that are not our own.
  Status read_arrays(const XmlElement& grid) {
    MeshFile& mesh = collector_.mesh;
    std::set<std::string_view> places;
    for (const XmlElement& array : grid.children) {
      const std::string_view name = array.value("Name"), type = array.value("AttributeType");
      if (array.name != "Attribute" || name.empty() || is_own_array(name)) continue;
      if (!type.empty() && type != "Scalar") continue;
      const bool of_points = array.value("Center") == "Node";
      if (!of_points && array.value("Center") != "Cell") continue;
      // Else a small file could name a large array a thousand times.
      const XmlElement* item = array.child("DataItem");
      if (item != nullptr && item->value("Format") == "HDF" && !places.insert(item->text).second)
        return wrong(fmt::format("two arrays are '{}'", legible(item->text)));
      auto values = numbers_in<Kind::values>(&array);
      if (!values) return std::move(values).error();
      if (values->size() != (of_points ? mesh.soup.points.size() : mesh.soup.triangles.size()))
        return wrong(fmt::format("{}: wrong size", legible(name)));
      if (of_points)
        mesh.point_arrays.push_back({std::string(name), *std::move(values)});
      else
        mesh.arrays.push_back({std::string(name), *std::move(values)});
    }
    return ok();
  }

  Status read_lines(const XmlElement& grid) {
    const auto cells = cells_of(grid, 2);
    if (!cells) return cells.error();
    auto groups = numbers_in<Kind::whole>(grid.child("Attribute", "LineID"));
    if (!groups) return std::move(groups).error();
    auto markers = numbers_in<Kind::whole>(grid.child("Attribute", "Marker"));
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
                                                           std::size_t corners) {
    const XmlElement* topology = grid.child("Topology");
    const auto nodes = numbers_in<Kind::whole>(topology);
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
  std::string_view hash_;  ///< of the file with the numbers; empty: not told
  std::string heavy_name_;
  std::unique_ptr<const std::string> heavy_text_;
  Hdf5Tree heavy_;  ///< of that text
};

}  // namespace

Result<MeshFile> parse_xdmf(std::string_view text, const std::string& source) {
  return XdmfReader(text, source).read();
}

}  // namespace cover
