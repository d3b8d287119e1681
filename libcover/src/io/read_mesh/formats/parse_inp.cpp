// Lines of fields; a field that begins with a star is a keyword and its parameters follow. Blocks
// other than nodes and triangles are passed over.
#include <fmt/core.h>

#include <algorithm>
#include <map>
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

class InpParser {
 public:
  InpParser(std::string_view text, const std::string& source)
      : lines_(text, source, '\0', Separator::comma) {}

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
      }
    }
    if (lines_.failed()) return lines_.error();
    return finish();
  }

 private:
  enum class Block { other, nodes, triangles };

  struct Element {
    long number = 0;
    std::vector<std::uint32_t> nodes;
    std::int64_t group = 0;
  };

  void begin_block(const std::string& keyword) {
    block_ = Block::other;
    if (keyword == "*NODE") block_ = Block::nodes;
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

  Result<MeshFile> finish() {
    std::stable_sort(elements_.begin(), elements_.end(),
                     [](const Element& a, const Element& b) { return a.number < b.number; });
    for (const Element& element : elements_) {
      collector_.add_triangle(element.nodes);
      collector_.mesh.group.push_back(element.group);
    }
    return collector_.finish();
  }

  FieldReader lines_;
  Block block_ = Block::other;
  std::size_t nodes_each_ = 3;
  std::int64_t group_ = 0;
  std::map<std::string, std::int64_t> groups_;
  std::unordered_map<long, std::uint32_t> index_;
  std::vector<Element> elements_;
  MeshCollector collector_;
};

}  // namespace

Result<MeshFile> parse_inp(std::string_view text, const std::string& source) {
  return InpParser(text, source).parse();
}

}  // namespace cover
