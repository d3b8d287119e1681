// Lines of fields; a field that begins with a star is a keyword and its parameters follow. Blocks
// other than nodes, triangles, sets and surfaces of edges are passed over.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

#include "io/read_mesh/mesh_collector.hpp"
#include "io/read_mesh/mesh_formats.hpp"
#include "io/text/field_reader.hpp"

namespace cover {
namespace {

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

/// Edges that surfaces may have, times those of all triangles: the same sets of elements can be
/// named again and again.
constexpr std::size_t kMostSurfaces = 16;

class InpParser {
 public:
  InpParser(std::string_view text, const std::string& source)
      : lines_(text, source, '\0', Separator::comma), source_(source) {}

  Result<MeshFile> parse() {
    while (lines_.next()) {
      const std::string_view first = lines_.fields().front();
      if (first.starts_with("**")) continue;
      if (first.starts_with('*')) {
        begin_block(upper(first));
      } else if (block_ == Block::nodes) {
        read_node();
      } else if (block_ == Block::triangles) {
        read_triangle();
      } else if (block_ == Block::set) {
        read_set();
      } else if (block_ == Block::node_set) {
        read_node_set();
      } else if (block_ == Block::surface) {
        read_edges();
      }
    }
    if (lines_.failed()) return lines_.error();
    return finish();
  }

 private:
  enum class Block { other, nodes, triangles, set, node_set, surface };

  /// Numbers from the first to the last one by steps.
  struct Range {
    long first = 0;
    long last = 0;
    long step = 1;
  };

  struct Element {
    long number = 0;
    std::vector<std::uint32_t> nodes;
    std::int64_t group = 0;
  };

  /// The same edge of some elements on a surface.
  struct Edges {
    std::string elements;  ///< a number or the name of a set, which may be told later
    std::size_t edge = 0;  ///< 0: of the first two nodes
    std::int64_t surface = 0;
  };

  void begin_block(const std::string& keyword) {
    block_ = Block::other;
    if (keyword == "*NODE") block_ = Block::nodes;
    if (keyword == "*ELSET") begin_set();
    if (keyword == "*NSET") begin_node_set();
    if (keyword == "*SURFACE") begin_surface();
    if (keyword != "*ELEMENT") return;
    const std::string type = parameter("TYPE=");
    nodes_each_ = type.ends_with('6') ? 6 : 3;
    const std::string family = type.substr(0, type.empty() ? 0 : type.size() - 1);
    const bool known = family == "S" || family == "CPS" || family == "CPE" || family == "CAX";
    if (!known || (!type.ends_with('3') && !type.ends_with('6'))) return;
    block_ = Block::triangles;
    const std::string set = parameter("ELSET=");
    group_ = groups_.emplace(set, static_cast<std::int64_t>(groups_.size()) + 1).first->second;
    if (!set.empty()) collector_.mesh.region_names.emplace(group_, set);
  }

  void begin_set() {
    block_ = Block::set;
    set_ = &sets_[parameter("ELSET=")];
    is_range_ = is_generated();
  }

  void begin_node_set() {
    if (is_generated()) return;  // a range, as of all nodes
    block_ = Block::node_set;
    node_sets_.push_back({parameter("NSET="), {}});
  }

  [[nodiscard]] bool is_generated() const {
    const auto& fields = lines_.fields();
    return std::any_of(fields.begin(), fields.end(),
                       [](std::string_view field) { return upper(field) == "GENERATE"; });
  }

  void begin_surface() {
    const std::string type = parameter("TYPE=");
    if (!type.empty() && type != "ELEMENT") return;
    block_ = Block::surface;
    const std::string name = parameter("NAME=");
    surface_ =
        surfaces_.emplace(name, static_cast<std::int64_t>(surfaces_.size()) + 1).first->second;
    collector_.mesh.line_names.emplace(surface_, name);
  }

  [[nodiscard]] std::string parameter(std::string_view name) const {
    for (const std::string_view field : lines_.fields()) {
      const std::string text = upper(field);
      if (text.starts_with(name)) return text.substr(name.size());
    }
    return {};
  }

  void read_node() {
    const long number = lines_.integer(0);
    const double x = lines_.real(1), y = lines_.real(2);
    const double z = lines_.fields().size() > 3 ? lines_.real(3) : 0;
    if (lines_.failed()) return;
    if (z != 0)
      return lines_.fail(ErrorCode::unsupported_format, "the mesh is not in the plane z = 0");
    auto& points = collector_.mesh.soup.points;
    if (!index_.emplace(number, static_cast<std::uint32_t>(points.size())).second)
      return lines_.fail(ErrorCode::syntax, fmt::format("node {} is given twice", number));
    points.push_back({x, y});
  }

  void read_triangle() {
    Element element{lines_.integer(0), {}, group_};
    for (std::size_t k = 1; k <= nodes_each_ && !lines_.failed(); ++k) {
      const long node = lines_.integer(k);
      const auto at = index_.find(node);
      if (at == index_.end())
        return lines_.fail(ErrorCode::id_out_of_range, fmt::format("node {} is not given", node));
      element.nodes.push_back(at->second);
    }
    if (!lines_.failed()) elements_.push_back(std::move(element));
  }

  /// Numbers of elements; names of other sets are passed over.
  void read_set() {
    if (is_range_) {
      const long step = lines_.fields().size() > 2 ? lines_.integer(2) : 1;
      const Range range{lines_.integer(0), lines_.integer(1), step};
      if (!lines_.failed() && step > 0) set_->push_back(range);
      return;
    }
    for (const std::string_view field : lines_.fields()) {
      if (const std::optional<long> number = parse_integer(field))
        set_->push_back({*number, *number, 1});
    }
  }

  /// Numbers of nodes; names of other sets are passed over.
  void read_node_set() {
    for (const std::string_view field : lines_.fields()) {
      const std::optional<long> number = parse_integer(field);
      const auto at = number ? index_.find(*number) : index_.end();
      if (at != index_.end()) node_sets_.back().nodes.push_back(at->second);
    }
  }

  /// Sides of other elements (of shells, say, or of bodies) are passed over.
  void read_edges() {
    if (lines_.fields().size() < 2) return;
    const std::string side = upper(lines_.fields()[1]);
    if (side.size() != 2 || side[0] != 'S' || side[1] < '1' || side[1] > '3') return;
    edges_.push_back(
        {upper(lines_.fields()[0]), static_cast<std::size_t>(side[1] - '1'), surface_});
  }

  Result<MeshFile> finish() {
    std::stable_sort(elements_.begin(), elements_.end(),
                     [](const Element& a, const Element& b) { return a.number < b.number; });
    for (const Element& element : elements_) {
      collector_.add_triangle(element.nodes);
      collector_.mesh.group.push_back(element.group);
    }
    std::erase_if(node_sets_, [&](const NodeSet& set) { return surfaces_.contains(set.name); });
    collector_.name_points_apart(node_sets_);
    for (const Edges& edges : edges_) {
      add_lines(edges);
      if (seen_ > 3 * kMostSurfaces * elements_.size())
        return Error{ErrorCode::syntax,
                     source_ + ": surfaces name the same edges of elements again and again",
                     {},
                     {}};
    }
    return collector_.finish();
  }

  void add_lines(const Edges& edges) {
    if (const std::optional<long> number = parse_integer(edges.elements)) {
      add_lines(edges, {*number, *number, 1});
    } else if (const auto set = sets_.find(edges.elements); set != sets_.end()) {
      for (const Range& range : set->second) add_lines(edges, range);
    }
  }

  void add_lines(const Edges& edges, const Range& range) {
    auto element =
        std::lower_bound(elements_.begin(), elements_.end(), range.first,
                         [](const Element& e, long number) { return e.number < number; });
    for (; element != elements_.end() && element->number <= range.last; ++element) {
      if (++seen_ > 3 * kMostSurfaces * elements_.size()) return;
      if ((element->number - range.first) % range.step != 0) continue;
      const std::size_t k = edges.edge;
      std::vector<std::uint32_t> nodes{element->nodes[k], element->nodes[(k + 1) % 3]};
      if (element->nodes.size() == 6) nodes.push_back(element->nodes[3 + k]);
      collector_.add_line(nodes, edges.surface);
    }
  }

  FieldReader lines_;
  std::string source_;
  Block block_ = Block::other;
  std::size_t nodes_each_ = 3;
  std::int64_t group_ = 0;
  std::map<std::string, std::int64_t> groups_;
  bool is_range_ = false;
  std::vector<Range>* set_ = nullptr;  ///< of the block that is read
  std::map<std::string, std::vector<Range>> sets_;
  std::vector<NodeSet> node_sets_;
  std::int64_t surface_ = 0;
  std::map<std::string, std::int64_t> surfaces_;
  std::vector<Edges> edges_;
  std::size_t seen_ = 0;  ///< elements looked at for surfaces
  std::unordered_map<long, std::uint32_t> index_;
  std::vector<Element> elements_;
  MeshCollector collector_;
};

}  // namespace

Result<MeshFile> parse_inp(std::string_view text, const std::string& source) {
  return InpParser(text, source).parse();
}

}  // namespace cover
