// Both versions become the same lists. Sections that are not needed are passed over.
// Tested by tests/unit/io/input/meshes/read_msh_test.cpp.
#include "io/read_mesh/formats/msh_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>

#include "base/numbers.hpp"
#include "io/text/text.hpp"
#include "io/text/token_reader.hpp"

namespace cover {
namespace {

/// Nodes of an element type, corners first.
struct ElementType {
  int number;
  int dimension;
  int corners;
  int nodes;
};

constexpr std::array kElementTypes{
    ElementType{15, 0, 1, 1},  ElementType{1, 1, 2, 2},   ElementType{8, 1, 2, 3},
    ElementType{26, 1, 2, 4},  ElementType{27, 1, 2, 5},  ElementType{28, 1, 2, 6},
    ElementType{2, 2, 3, 3},   ElementType{9, 2, 3, 6},   ElementType{20, 2, 3, 9},
    ElementType{21, 2, 3, 10}, ElementType{22, 2, 3, 12}, ElementType{23, 2, 3, 15},
    ElementType{24, 2, 3, 15}, ElementType{25, 2, 3, 21}, ElementType{3, 2, 4, 4},
    ElementType{16, 2, 4, 8},  ElementType{10, 2, 4, 9},  ElementType{36, 2, 4, 16},
    ElementType{37, 2, 4, 25},
};

class MshParser {
 public:
  MshParser(std::string_view text, const std::string& source) : tokens_(text, source) {}

  Result<MshFile> parse() {
    read_format();
    while (!tokens_.failed()) {
      const std::string_view section = tokens_.word();
      if (section.empty()) break;
      read_section(section);
    }
    if (!tokens_.failed() && !has_elements_)
      tokens_.fail(ErrorCode::truncated, "the file has no $Elements");
    if (!tokens_.failed()) check_plane();
    if (tokens_.failed()) return tokens_.error();
    return std::move(file_);
  }

 private:
  void read_format() {
    tokens_.expect("$MeshFormat");
    const double version = tokens_.real("the version of the format");
    const long binary = tokens_.integer("the file type, 0 or 1");
    tokens_.integer("the size of a number");
    if (tokens_.failed()) return;
    if (binary != 0 && binary != 1)
      return tokens_.fail(ErrorCode::syntax,
                          fmt::format("the file type is {}; 0 is text, 1 binary", binary));
    binary_ = binary == 1;
    newer_ = version >= 4;
    file_.has_entities = !newer_;
    if (!(version >= 2 && version < 3) && version != 4.1)
      return tokens_.fail(ErrorCode::unsupported_format,
                          fmt::format("version {} of .msh; versions 2.2 and 4.1 are read "
                                      "(gmsh -format msh22 or msh41)",
                                      version));
    begin_data();
    if (binary_ && tokens_.integer("the number one") != 1)
      return tokens_.fail(ErrorCode::unsupported_format,
                          "a binary .msh with another order of bytes than this machine's");
    end_data();
    tokens_.expect("$EndMeshFormat");
  }

  /// Between these, numbers are binary data in a binary file.
  void begin_data() { tokens_.set_binary(binary_); }
  void end_data() { tokens_.set_binary(false); }

  void read_section(std::string_view section) {
    if (section.size() < 2 || section[0] != '$')
      return tokens_.fail(ErrorCode::syntax, "expected the head of a section, as $Nodes");
    if (section == "$PhysicalNames")
      read_names();
    else if (section == "$Entities" && newer_)
      read_entities();
    else if (section == "$Nodes")
      newer_ ? read_node_blocks() : read_nodes();
    else if (section == "$Elements")
      newer_ ? read_element_blocks() : read_elements();
    else if (section == "$NodeData" && !binary_)
      return read_data(section, file_.points.size(), file_.point_arrays);
    else if (section == "$ElementData" && !binary_)
      return read_data(section, file_.elements.size(), file_.element_arrays);
    else {
      file_.has_periodic_points |= section == "$Periodic";
      if (section == "$PartitionedEntities" && !binary_) file_.parts = tokens_.count("parts");
      return tokens_.skip_past("$End" + std::string(section.substr(1)));
    }
    tokens_.expect("$End" + std::string(section.substr(1)));
  }

  void read_names() {
    const std::size_t n = tokens_.count("physical names");
    for (std::size_t i = 0; i < n && !tokens_.failed(); ++i) {
      const long dimension = tokens_.integer("the dimension of a physical group");
      const long tag = tokens_.integer("the number of a physical group");
      file_.names[{dimension, tag}] = tokens_.quoted("the name of a physical group");
    }
  }

  void read_entities() {
    begin_data();
    std::array<std::size_t, 4> counts{};
    for (std::size_t& n : counts) n = tokens_.wide_count("entities");
    for (long dimension = 0; dimension < 4; ++dimension)
      for (std::size_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
        if (tokens_.failed()) return;
        const long tag = tokens_.integer("the number of an entity");
        for (int k = dimension == 0 ? 3 : 6; k > 0; --k) tokens_.real("a coordinate");
        const std::size_t groups = tokens_.wide_count("physical groups");
        for (std::size_t k = 0; k < groups && !tokens_.failed(); ++k) {
          const long group = tokens_.integer("the number of a physical group");
          const bool is_first = physical_.try_emplace({dimension, tag}, std::abs(group)).second;
          if (!is_first && dimension > 0) ++file_.in_several_groups;
        }
        const std::size_t limits = dimension == 0 ? 0 : tokens_.wide_count("bounding entities");
        for (std::size_t k = 0; k < limits && !tokens_.failed(); ++k)
          tokens_.integer("a bounding entity");
      }
    end_data();
  }

  void read_nodes() {
    const std::size_t n = tokens_.count("nodes");
    begin_data();
    for (std::size_t i = 0; i < n && !tokens_.failed(); ++i)
      read_coordinates(tokens_.integer("the number of a node"), 0);
    end_data();
  }

  void read_node_blocks() {
    begin_data();
    const std::size_t blocks = tokens_.wide_count("blocks of nodes");
    for (int k = 0; k < 3; ++k) tokens_.wide_integer("the number of nodes and their range");
    for (std::size_t b = 0; b < blocks && !tokens_.failed(); ++b) {
      const long dimension = tokens_.integer("the dimension of an entity");
      tokens_.integer("the number of an entity");
      const bool parametric = tokens_.integer("whether nodes have parameters") != 0;
      const std::size_t n = tokens_.wide_count("nodes");
      std::vector<long> ids;
      for (std::size_t i = 0; i < n && !tokens_.failed(); ++i)
        ids.push_back(tokens_.wide_integer("the number of a node"));
      for (std::size_t i = 0; i < ids.size() && !tokens_.failed(); ++i)
        read_coordinates(ids[i], parametric ? std::clamp(dimension, 0L, 3L) : 0);
    }
    end_data();
  }

  void read_coordinates(long id, long parameters) {
    const double x = tokens_.real("a coordinate");
    const double y = tokens_.real("a coordinate");
    const double z = tokens_.real("a coordinate");
    for (; parameters > 0; --parameters) tokens_.real("a parameter");
    if (!index_.emplace(id, static_cast<std::uint32_t>(file_.points.size())).second)
      tokens_.fail(ErrorCode::syntax, fmt::format("node {} is given twice", id));
    file_.points.push_back({x, y});
    file_.point_ids.push_back(id);
    heights_.push_back(z);
  }

  void read_elements() {
    has_elements_ = true;
    const std::size_t n = tokens_.count("elements");
    if (binary_) return read_element_runs(n);
    for (std::size_t i = 0; i < n && !tokens_.failed(); ++i) {
      const long id = tokens_.integer("the number of an element");
      const ElementType* type = read_type();
      const std::size_t tags = tokens_.count("tags of an element");
      if (type) read_element(id, tags, *type);
    }
  }

  /// Binary: each head says what type the next elements are of, and how many tags they have.
  void read_element_runs(std::size_t n) {
    begin_data();
    for (std::size_t i = 0; i < n && !tokens_.failed();) {
      const ElementType* type = read_type();
      const std::size_t many = tokens_.count("elements of one type");
      const std::size_t tags = tokens_.count("tags of an element");
      if (many == 0) tokens_.fail(ErrorCode::syntax, "a head of elements without elements");
      for (std::size_t k = 0; type && k < many && !tokens_.failed(); ++k, ++i)
        read_element(tokens_.integer("the number of an element"), tags, *type);
    }
    end_data();
  }

  /// REQUIRES: version 2; its number has been read
  void read_element(long id, std::size_t tags, const ElementType& type) {
    MshElement element{id, 0, 0, 0, 0, 0, 0};
    for (std::size_t k = 0; k < tags && !tokens_.failed(); ++k) {
      const long tag = tokens_.integer("a tag of an element");
      if (k == 0) element.physical = std::abs(tag);
      if (k == 1) element.entity = tag;
    }
    read_nodes_of(element, type);
  }

  void read_element_blocks() {
    has_elements_ = true;
    begin_data();
    const std::size_t blocks = tokens_.wide_count("blocks of elements");
    for (int k = 0; k < 3; ++k) tokens_.wide_integer("the number of elements and their range");
    for (std::size_t b = 0; b < blocks && !tokens_.failed(); ++b) {
      const long dimension = tokens_.integer("the dimension of an entity");
      const long entity = tokens_.integer("the number of an entity");
      const ElementType* type = read_type();
      const auto group = physical_.find({dimension, entity});
      const long physical = group == physical_.end() ? 0 : group->second;
      const std::size_t n = tokens_.wide_count("elements");
      for (std::size_t i = 0; type && i < n && !tokens_.failed(); ++i) {
        const long id = tokens_.wide_integer("the number of an element");
        read_nodes_of({id, 0, physical, entity, 0, 0, 0}, *type);
      }
    }
    end_data();
  }

  const ElementType* read_type() {
    const long number = tokens_.integer("the type of an element");
    const auto* type = std::find_if(kElementTypes.begin(), kElementTypes.end(),
                                    [&](const ElementType& t) { return t.number == number; });
    if (type != kElementTypes.end()) return type;
    tokens_.fail(ErrorCode::unsupported_format,
                 fmt::format("elements of type {}; points, lines, triangles and quadrangles of a "
                             "plane mesh are read",
                             number));
    return nullptr;
  }

  void read_nodes_of(MshElement element, const ElementType& type) {
    element.dimension = type.dimension;
    element.first_node = file_.nodes.size();
    element.corners = static_cast<std::uint32_t>(type.corners);
    element.nodes = static_cast<std::uint32_t>(type.nodes);
    for (int k = 0; k < type.nodes; ++k) {
      const long node = newer_ ? tokens_.wide_integer("a node of an element")
                               : tokens_.integer("a node of an element");
      if (tokens_.failed()) return;
      const auto at = index_.find(node);
      if (at == index_.end())
        return tokens_.fail(
            ErrorCode::id_out_of_range,
            fmt::format("element {} has the node {}, which is not given", element.id, node));
      file_.nodes.push_back(at->second);
    }
    file_.elements.push_back(element);
  }

  /// One number for each of `items`; other data are passed over.
  void read_data(std::string_view section, std::size_t items,
                 std::vector<PlaneField::Array>& arrays) {
    const std::string end = "$End" + std::string(section.substr(1));
    PlaneField::Array array;
    const std::size_t texts = tokens_.count("words of data");
    for (std::size_t k = 0; k < texts && !tokens_.failed(); ++k) {
      std::string text = tokens_.quoted("the name of data");
      if (k == 0) array.name = std::move(text);
    }
    const std::size_t reals = tokens_.count("numbers of data");
    for (std::size_t k = 0; k < reals && !tokens_.failed(); ++k) tokens_.word();
    std::vector<long> numbers;  // the step in time, components, values
    const std::size_t integers = tokens_.count("whole numbers of data");
    for (std::size_t k = 0; k < integers && !tokens_.failed(); ++k)
      numbers.push_back(tokens_.integer("a number of data"));
    if (tokens_.failed()) return;
    if (array.name.empty() || numbers.size() < 3 || numbers[1] != 1 || numbers[2] < 1 ||
        static_cast<std::size_t>(numbers[2]) != items)
      return tokens_.skip_past(end);
    const bool of_points = &arrays == &file_.point_arrays;
    if (!of_points && element_index_.empty())
      for (std::size_t e = 0; e < file_.elements.size(); ++e)
        element_index_.emplace(file_.elements[e].id, static_cast<std::uint32_t>(e));
    const auto& index = of_points ? index_ : element_index_;
    array.values.assign(items, kNoNumber);
    for (std::size_t k = 0; k < items && !tokens_.failed(); ++k) {
      const auto at = index.find(tokens_.integer("the number of a node or element"));
      const std::optional<double> value = parse_double(tokens_.word());  // "nan" is none
      if (at == index.end())
        return tokens_.fail(ErrorCode::id_out_of_range,
                            "a value of a node or element that is not "
                            "given");
      if (value) array.values[at->second] = *value;
    }
    tokens_.expect(end);
    arrays.push_back(std::move(array));
  }

  /// All elements must lie at one height.
  void check_plane() {
    for (const std::uint32_t p : file_.nodes) {
      const std::uint32_t first = file_.nodes.front();
      if (heights_[p] != heights_[first])
        return tokens_.fail(
            ErrorCode::unsupported_format,
            fmt::format("the mesh is not in a plane z = constant: node {} has z = {}, node {} {}",
                        file_.point_ids[first], heights_[first], file_.point_ids[p], heights_[p]));
    }
  }

  TokenReader tokens_;
  bool newer_ = false;
  bool binary_ = false;
  bool has_elements_ = false;
  std::map<std::pair<long, long>, long> physical_;  // of entities, by dimension and tag
  std::unordered_map<long, std::uint32_t> index_;   // of nodes
  std::unordered_map<long, std::uint32_t> element_index_;
  std::vector<double> heights_;  // z by node
  MshFile file_;
};

}  // namespace

Result<MshFile> parse_msh_file(std::string_view text, const std::string& source) {
  return MshParser(text, source).parse();
}

}  // namespace cover
