// The meshes of process and device simulators in text: TIF (TSUPREM-4, MEDICI) and SUPREM-IV's
// structure files (.str, also Silvaco's). Both have a record on each line, known by its first word:
//
//   c ID X Y ...              a coordinate, in micrometres; y points downwards
//   r ID MATERIAL ...         a region; TIF: by name, SUPREM-IV: by number
//   e ID C1 C2 ...            an edge; i ID KIND NAME ... and j EDGE, TIF: an electrode's edges
//   t ID REGION C1 C2 C3 ...  a triangle
//   s N NAME...               what the values are; SUPREM-IV: by number
//   n C MATERIAL VALUE...     values in one material; at interfaces a coordinate has several
//
// The geometry is the borders between regions, as of any mesh; the values become Input::field.
// Coordinates stay as they are. Tested by tests/unit/io/input/meshes/read_tcad_mesh_test.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "geom/topology/mesh_borders.hpp"
#include "io/input/formats.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// Of SUPREM-IV; the gas is no material of a mesh.
constexpr std::array kSupremMaterials{"Gas",        "SiO2", "Nitride",     "Si",  "Poly",
                                      "Oxynitride", "Al",   "Photoresist", "GaAs"};
constexpr std::array kSupremValues{"vacancies",  "interstitials", "arsenic",
                                   "phosphorus", "antimony",      "boron"};
/// Records that say nothing of geometry or values: headers, models, mechanics, boundaries of
/// regions, which triangles have too.
const std::set<std::string_view> kLeftOut{"h", "cd", "cg", "b", "mo", "simpur", "v", "D", "M", "I"};

enum class Dialect { tif, suprem };

std::string material_of(std::string_view word, Dialect dialect) {
  const std::optional<long> number = parse_integer(word);
  if (dialect == Dialect::tif || !number) return std::string(word);
  if (*number >= 0 && *number < std::ssize(kSupremMaterials))
    return kSupremMaterials.at(static_cast<std::size_t>(*number));
  return fmt::format("material_{}", *number);
}

std::string value_name_of(std::string_view word, Dialect dialect) {
  const std::optional<long> number = parse_integer(word);
  if (dialect == Dialect::tif || !number) return std::string(word);
  if (*number >= 0 && *number < std::ssize(kSupremValues))
    return kSupremValues.at(static_cast<std::size_t>(*number));
  return fmt::format("value_{}", *number);
}

class TcadReader {
 public:
  TcadReader(std::string_view text, const std::string& source, Dialect dialect)
      : lines_(text, source, '\1'),
        dialect_(dialect),
        ends_a_line_(text.empty() || text.back() == '\n') {
    mesh_.source = source;
  }

  Result<Input> read() {
    while (!error_ && lines_.next()) read_record(lines_.fields());
    if (!error_) add_triangles();
    if (!error_) check_end();
    if (!error_) add_electrodes();
    if (!error_ && mesh_.cells() == 0)
      error_ =
          Error{ErrorCode::truncated, fmt::format("{}: no triangles in it", mesh_.source), {}, {}};
    if (error_) return *error_;
    auto field = std::make_shared<const PlaneField>(make_field());
    Input input = borders_of(mesh_);
    input.unit = "um";
    if (!field->arrays.empty()) input.field = std::move(field);
    if (without_values_ > 0)
      input.warnings.push_back(fmt::format(
          "{} in materials that have values {} none: the file may have been cut short",
          counted(without_values_, "coordinate"), without_values_ == 1 ? "has" : "have"));
    if (!strange_.empty())
      input.warnings.push_back(
          fmt::format("{} of unknown kinds left out: {}", counted(strange_lines_, "line"),
                      listed(std::vector<std::string>(strange_.begin(), strange_.end()))));
    return input;
  }

 private:
  using Fields = std::vector<std::string_view>;
  /// A triangle as the file has it.
  struct Cell {
    long region;
    std::array<long, 3> corners;
    int line;
  };
  struct Values {
    long node;
    std::uint32_t material;
    std::size_t first;  ///< in values_
    int line;
  };

  void fail(ErrorCode code, const std::string& what) {
    if (!error_) error_ = lines_.error(code, what);
  }
  void fail_at(int line, ErrorCode code, const std::string& what) {
    if (!error_) error_ = Error{code, fmt::format("{}:{}: {}", mesh_.source, line, what), {}, {}};
  }

  long integer(const Fields& f, std::size_t k, std::string_view what) {
    if (k >= f.size()) {
      fail(ErrorCode::truncated, fmt::format("{} is missing", what));
      return 0;
    }
    const std::optional<long> value = parse_integer(f[k]);
    if (!value) fail(ErrorCode::syntax, fmt::format("{}: '{}' is no integer", what, legible(f[k])));
    return value.value_or(0);
  }

  double real(const Fields& f, std::size_t k, std::string_view what) {
    if (k >= f.size()) {
      fail(ErrorCode::truncated, fmt::format("{} is missing", what));
      return 0;
    }
    const std::optional<double> value = parse_double(f[k]);
    if (!value) fail(ErrorCode::syntax, fmt::format("{}: '{}' is no number", what, legible(f[k])));
    return value.value_or(0);
  }

  std::string word(const Fields& f, std::size_t k, std::string_view what) {
    if (k < f.size()) return std::string(f[k]);
    fail(ErrorCode::truncated, fmt::format("{} is missing", what));
    return {};
  }

  void read_record(const Fields& f) {
    const std::string_view kind = f[0];
    if (kind == "c") return read_coordinate(f);
    if (kind == "t") return read_triangle(f);
    if (kind == "n") return read_values(f);
    if (kind == "e") return read_edge(f);
    if (kind == "r") return read_region(f);
    if (kind == "s") return read_names(f);
    if (dialect_ == Dialect::tif && kind == "i") return read_electrode(f);
    if (dialect_ == Dialect::tif && kind == "j") return read_electrode_edge(f);
    if (kLeftOut.contains(kind)) return;
    constexpr std::size_t kMostNamed = 8;
    ++strange_lines_;
    if (strange_.size() < kMostNamed) strange_.insert(legible(kind));
  }

  void read_coordinate(const Fields& f) {
    const long id = integer(f, 1, "the number of the coordinate");
    const Point p{real(f, 2, "x"), real(f, 3, "y")};
    if (error_) return;
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      return fail(ErrorCode::non_finite_coordinate, "the coordinate is not finite");
    if (!node_.emplace(id, static_cast<std::uint32_t>(mesh_.points.size())).second)
      return fail(ErrorCode::syntax, fmt::format("there is a coordinate {} already", id));
    mesh_.points.push_back(p);
    mesh_.point_ids.push_back(id);
  }

  void read_region(const Fields& f) {
    const long id = integer(f, 1, "the number of the region");
    const std::string material = material_of(word(f, 2, "the material of the region"), dialect_);
    if (error_) return;
    if (!region_.emplace(id, static_cast<std::uint32_t>(mesh_.materials.size())).second)
      return fail(ErrorCode::syntax, fmt::format("there is a region {} already", id));
    mesh_.materials.push_back(material);
  }

  void read_triangle(const Fields& f) {
    Cell cell{integer(f, 2, "the region of the triangle"), {}, lines_.line()};
    for (std::size_t k = 0; k < 3; ++k)
      cell.corners[k] = integer(f, 3 + k, "a corner of the triangle");
    cells_.push_back(cell);
  }

  void read_edge(const Fields& f) {
    if (dialect_ == Dialect::suprem) return;
    const long id = integer(f, 1, "the number of the edge");
    edge_[id] = {integer(f, 2, "an end of the edge"), integer(f, 3, "an end of the edge")};
  }

  void read_electrode(const Fields& f) {
    electrodes_.push_back({word(f, 3, "the name of the electrode"), {}});
  }

  void read_electrode_edge(const Fields& f) {
    const long id = integer(f, 1, "the number of the edge");
    if (electrodes_.empty()) return fail(ErrorCode::syntax, "an edge of no electrode");
    electrodes_.back().second.emplace_back(id, lines_.line());
  }

  void read_names(const Fields& f) {
    const long count = integer(f, 1, "the number of values");
    if (!names_.empty()) return fail(ErrorCode::syntax, "a second list of values");
    // Their lines hold as many values as were named before them: none.
    if (!nodes_.empty()) return fail(ErrorCode::syntax, "values before the list of their names");
    if (error_) return;
    if (count < 0 || static_cast<std::size_t>(count) > f.size() - 2)
      return fail(ErrorCode::syntax,
                  fmt::format("{} values are announced, {} named", count, f.size() - 2));
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
      names_.push_back(value_name_of(f[2 + k], dialect_));
  }

  void read_values(const Fields& f) {
    const long node = integer(f, 1, "the number of the coordinate");
    const std::string material = material_of(word(f, 2, "the material of the values"), dialect_);
    if (error_) return;
    const auto at = material_.emplace(material, static_cast<std::uint32_t>(material_.size())).first;
    nodes_.push_back({node, at->second, values_.size(), lines_.line()});
    for (std::size_t k = 0; k < names_.size(); ++k)
      values_.push_back(real(f, 3 + k, fmt::format("the value of {}", names_[k])));
  }

  std::optional<std::uint32_t> node_of(long id, int line) {
    const auto found = node_.find(id);
    if (found != node_.end()) return found->second;
    fail_at(line, ErrorCode::id_out_of_range, fmt::format("there is no coordinate {}", id));
    return std::nullopt;
  }

  void add_triangles() {
    for (const Cell& cell : cells_) {
      const auto region = region_.find(cell.region);
      if (region == region_.end())
        return fail_at(cell.line, ErrorCode::id_out_of_range,
                       fmt::format("there is no region {}", cell.region));
      std::vector<std::uint32_t> corners;
      for (const long id : cell.corners) {
        const std::optional<std::uint32_t> node = node_of(id, cell.line);
        if (!node) return;
        corners.push_back(*node);
      }
      const bool is_gas =
          dialect_ == Dialect::suprem && mesh_.materials[region->second] == kSupremMaterials[0];
      if (!is_gas) mesh_.add_cell(corners, region->second);
    }
  }

  /// No line says how much follows: a file that was cut short within its triangles has coordinates
  /// that are in none, or ends in the middle of a line, and has no values, which come last.
  void check_end() {
    if (!nodes_.empty() || cells_.empty()) return;
    std::vector<bool> used(mesh_.points.size());
    for (const Cell& cell : cells_)
      for (const long id : cell.corners) used[node_.at(id)] = true;
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end())
      return fail(ErrorCode::truncated,
                  fmt::format("the file ends here, but coordinate {} is in no triangle",
                              mesh_.point_ids[static_cast<std::size_t>(unused - used.begin())]));
    if (!ends_a_line_) fail(ErrorCode::truncated, "the file ends in the middle of its triangles");
  }

  void add_electrodes() {
    for (const auto& [name, edges] : electrodes_) {
      for (const auto& [id, line] : edges) {
        const auto edge = edge_.find(id);
        if (edge == edge_.end())
          return fail_at(line, ErrorCode::id_out_of_range, fmt::format("there is no edge {}", id));
        const auto a = node_of(edge->second[0], line), b = node_of(edge->second[1], line);
        if (!a || !b) return;
        mesh_.lines.push_back({*a, *b, name, 0, id});
      }
    }
  }

  /// Where SUPREM-IV counts coordinates from 1, some writers count those of values from 0.
  [[nodiscard]] long offset_of_nodes() const {
    const bool from_0 =
        std::any_of(nodes_.begin(), nodes_.end(), [](const Values& v) { return v.node == 0; });
    return from_0 && !node_.contains(0) ? 1 : 0;
  }

  /// Each coordinate once for each material that it has values in. Counts those that have none.
  PlaneField make_field() {
    PlaneField field;
    if (nodes_.empty() || names_.empty()) return field;
    const auto key = [](std::uint32_t node, std::uint32_t material) {
      return std::uint64_t{node} << 32U | material;
    };
    std::unordered_map<std::uint64_t, std::size_t> values;  // where they begin
    const long offset = offset_of_nodes();
    for (const Values& v : nodes_) {
      // The largest number has none behind it.
      if (v.node > std::numeric_limits<long>::max() - offset) continue;
      const auto node = node_.find(v.node + offset);
      if (node != node_.end()) values.emplace(key(node->second, v.material), v.first);
    }
    for (const std::string& name : names_) field.arrays.push_back({name, {}});
    std::unordered_map<std::uint64_t, std::uint32_t> point;
    for (std::size_t c = 0; c < mesh_.cells(); ++c) {
      const std::string& name = mesh_.materials[mesh_.material[c]];
      const auto at = material_.find(name);
      const std::uint32_t material =
          at != material_.end() ? at->second : std::numeric_limits<std::uint32_t>::max();
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t node = mesh_.corners[mesh_.first[c] + k];
        const auto [entry, is_new] =
            point.emplace(key(node, material), static_cast<std::uint32_t>(field.points.size()));
        corners[k] = entry->second;
        if (!is_new) continue;
        field.points.push_back(mesh_.points[node]);
        const auto first = values.find(key(node, material));
        if (at != material_.end() && first == values.end()) ++without_values_;
        for (std::size_t a = 0; a < names_.size(); ++a)
          field.arrays[a].values.push_back(first != values.end() ? values_[first->second + a]
                                                                 : kNoNumber);
      }
      field.triangles.push_back(corners);
      field.material.push_back(name);
    }
    return field;
  }

  LineReader lines_;
  Dialect dialect_;
  bool ends_a_line_;
  CellMesh mesh_;
  std::unordered_map<long, std::uint32_t> node_;    ///< by id
  std::unordered_map<long, std::uint32_t> region_;  ///< by id, index into mesh_.materials
  std::unordered_map<long, std::array<long, 2>> edge_;
  std::vector<Cell> cells_;
  /// Names, edges and the lines where they stand.
  std::vector<std::pair<std::string, std::vector<std::pair<long, int>>>> electrodes_;
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t> material_;  ///< of values
  std::vector<Values> nodes_;
  std::vector<double> values_;
  std::set<std::string> strange_;
  std::size_t strange_lines_ = 0;
  std::size_t without_values_ = 0;  ///< coordinates by material, where others have some
  std::optional<Error> error_;
};

}  // namespace

Result<Input> parse_tif(std::string_view text, const std::string& source) {
  return TcadReader(text, source, Dialect::tif).read();
}

Result<Input> parse_suprem(std::string_view text, const std::string& source) {
  return TcadReader(text, source, Dialect::suprem).read();
}

}  // namespace cover
