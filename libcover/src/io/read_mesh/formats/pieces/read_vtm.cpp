// Pieces are gathered by the numbers that vertices have in the whole mesh.
// Tested by tests/unit/io/read_mesh/read_output_test.cpp.
#include "io/read_mesh/formats/pieces/read_vtm.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "base/containers/order.hpp"
#include "base/faults/errors.hpp"
#include "base/numbers.hpp"
#include "io/read_mesh/complete_mesh.hpp"
#include "io/read_mesh/formats/pieces/piece_files.hpp"
#include "io/read_mesh/second_order.hpp"
#include "io/text/array_names.hpp"
#include "io/text/text.hpp"
#include "io/text/xml_tree.hpp"
#include "io/vtk_files/arrays/whole_number.hpp"
#include "io/vtk_files/read_data_set.hpp"

namespace cover {
namespace {

/// One block of a group: a grid and its name.
struct Block {
  std::string group;
  std::string name;
  DataSetFile file;
};

/// The files that a .vtm names, read: those of `<Block name="...">` and no deeper.
class BlockFiles {
 public:
  explicit BlockFiles(const std::string& path) : path_(path), files_(path) {}

  /// What stands behind the blocks; nothing in files of old versions.
  [[nodiscard]] const std::optional<XmlElement>& names() const { return names_; }

  Result<std::vector<Block>> read() {
    const Result<std::string> text = read_file(path_);
    if (!text) return text.error();
    const Result<XmlTree> tree = parse_xml(*text, path_);
    if (!tree) return tree.error();
    const XmlElement* root = tree->root.child("vtkMultiBlockDataSet");
    if (tree->root.name != "VTKFile" || root == nullptr)
      return wrong_file(path_, "not a valid VTK file: no multi-block data set");
    for (const XmlElement& group : root->children) {
      if (group.name != "Block") continue;
      for (const XmlElement& block : group.children) {
        if (block.name != "DataSet") continue;
        if (Status status = read_block(group.value("name"), block); !status)
          return std::move(status).error();
      }
    }
    if (const XmlElement* names = tree->root.child("CoverNames")) names_ = *names;
    return std::move(blocks_);
  }

 private:
  Status read_block(std::string_view group, const XmlElement& element) {
    const std::string_view file = element.value("file");
    if (file.empty()) return ok();  // a block without cells has none
    Result<DataSetFile> data = files_.read(file);
    if (!data) return std::move(data).error();
    blocks_.push_back({std::string(group), std::string(element.value("name")), std::move(*data)});
    return ok();
  }

  const std::string& path_;
  PieceFiles files_;
  std::vector<Block> blocks_;
  std::optional<XmlElement> names_;
};

/// Takes over the names and the origin; those of regions, lines and points that are not there are
/// left.
void take_names(const XmlElement& names, StoredMesh& stored) {
  const auto text = [](const XmlElement& element, const char* name) {
    return std::string(element.value(name));
  };
  stored.provenance.source = text(names, "Source");
  stored.provenance.version = text(names, "Version");
  stored.unit = text(names, "Unit");
  stored.scale = parse_double(names.value("Scale")).value_or(1);
  const long points = parse_integer(names.value("InputVertices")).value_or(0);
  if (points > 0 && static_cast<std::size_t>(points) <= stored.soup.points.size())
    stored.input_vertices = static_cast<std::size_t>(points);
  stored.cut_vertices =
      static_cast<std::size_t>(std::max(parse_integer(names.value("CutVertices")).value_or(0), 0L));
  for (const XmlElement& element : names.children) {
    if (element.name == "Option")
      stored.provenance.settings.push_back({text(element, "Name"), text(element, "Value")});
    if (element.name == "Point") {
      const long vertex = parse_integer(element.value("Vertex")).value_or(-1);
      if (vertex >= 0 && static_cast<std::size_t>(vertex) < stored.soup.points.size())
        stored.points.push_back(
            {VertexId(static_cast<std::uint32_t>(vertex)), text(element, "Name")});
      continue;
    }
    const long id = parse_integer(element.value("Id")).value_or(0);
    if (id < 1) continue;
    const std::size_t k = static_cast<std::size_t>(id) - 1;
    if (element.name == "Region" && k < stored.regions.size()) {
      stored.regions[k].name = text(element, "Name");
      stored.regions[k].material_name = text(element, "Material");
    } else if (element.name == "Line" && k < stored.interfaces.size()) {
      stored.interfaces[k].name = text(element, "Name");
    }
  }
}

/// The words of attributes, as write_vtm() puts them beside the names.
ArrayWords words_of(const XmlElement& names) {
  ArrayWords words;
  for (const XmlElement& element : names.children) {
    if (element.name != "Attribute" || element.children.empty()) continue;
    std::vector<std::string>& all = words[std::string(element.value("Name"))];
    for (const XmlElement& word : element.children) all.emplace_back(word.value("Name"));
  }
  return words;
}

/// The names of attributes, in the order of the input.
std::vector<std::string> attributes_of(const XmlElement& names) {
  std::vector<std::string> attributes;
  for (const XmlElement& element : names.children)
    if (element.name == "Attribute") attributes.emplace_back(element.value("Name"));
  return attributes;
}

/// The names of the arrays that all blocks of regions have and that are not our own, in the order
/// of the first block.
std::vector<std::string> common_arrays(const std::vector<Block>& blocks,
                                       std::vector<NumberArray> DataSet::*arrays) {
  std::vector<std::string> common;
  bool is_first = true;
  for (const Block& block : blocks) {
    if (block.group != "regions") continue;
    std::set<std::string> names;
    for (const NumberArray& array : block.file.data.*arrays) {
      const bool is_new = names.insert(array.name).second;
      if (is_first && is_new && !is_own_array(array.name)) common.push_back(array.name);
    }
    std::erase_if(common, [&](const std::string& name) { return !names.contains(name); });
    is_first = false;
  }
  return common;
}

/// Gathers the blocks of a .vtm into one mesh again, by the numbers that vertices have in it.
class BlockReader {
 public:
  std::vector<CellArray> of_triangles;        ///< in the order of the triangles
  std::vector<PlaneField::Array> of_points;   ///< complete after finish()
  RegionValues region_values;                 ///< of these, likewise
  std::vector<std::array<Point, 3>> middles;  ///< complete after finish()
  bool has_periodic_points = false;

  /// `most` is above any number of a vertex, a region or an interface: what the blocks have in all.
  BlockReader(StoredMesh& stored, std::uint32_t most) : stored_(stored), most_(most) {}

  /// The arrays to be gathered, which all blocks of regions have.
  void expect_arrays(const std::vector<Block>& blocks) {
    for (const std::string& name : common_arrays(blocks, &DataSet::cell_arrays))
      of_triangles.push_back({name, {}});
    for (const std::string& name : common_arrays(blocks, &DataSet::point_arrays))
      of_points.push_back({name, {}});
  }

  /// False if an array that write_vtm() writes is missing.
  bool add_regions(const Block& block) {
    if (!start(block.file.data)) return false;
    const NumberArray* region = data_->array_of_cells("RegionId");
    const NumberArray* material = data_->array_of_cells("material");
    if (region == nullptr || material == nullptr) return false;
    if (!take_arrays_of_block()) return false;
    for (std::size_t c = 0; c < data_->cell_count(); ++c) {
      if (!take_nodes(c, 3)) return false;
      const std::uint32_t id = number(*region, c);
      if (id == 0 || id > most_) return false;
      const std::uint32_t of_material = number(*material, c);
      if (of_material > static_cast<std::uint32_t>(std::numeric_limits<int>::max())) return false;
      stored_.soup.triangles.push_back({nodes_[0], nodes_[1], nodes_[2]});
      if (nodes_.size() == 6) middles_.push_back({nodes_[3], nodes_[4], nodes_[5]});
      stored_.soup.region.push_back(id);
      stored_.soup.material.push_back(of_material);
      if (stored_.regions.size() < id) stored_.regions.resize(id);
      Region& entry = stored_.regions[id - 1];
      if (entry.material != 0) continue;
      entry.id = RegionId(id);
      entry.material = static_cast<int>(of_material);
      entry.name = block.name;
      entry.material_name = fmt::format("material_{}", of_material);
    }
    return true;
  }

  bool add_lines(const Block& block) {
    if (!start(block.file.data)) return false;
    const NumberArray* line = data_->array_of_cells("LineID");
    const NumberArray* left = data_->array_of_cells("LeftRegion");
    const NumberArray* right = data_->array_of_cells("RightRegion");
    const NumberArray* kind = data_->array_of_cells("LineKind");
    const NumberArray* marker = data_->array_of_cells("marker");
    if (line == nullptr || left == nullptr || right == nullptr || kind == nullptr ||
        marker == nullptr)
      return false;
    for (std::size_t c = 0; c < data_->cell_count(); ++c) {
      if (!take_nodes(c, 2)) return false;
      const std::uint32_t id = number(*line, c);
      if (id == 0 || id > most_) return false;
      const int mark = static_cast<int>(whole_number(value(*marker, c)));
      stored_.edges.push_back({nodes_[0], nodes_[1], InterfaceId(id), mark});
      if (stored_.interfaces.size() < id) stored_.interfaces.resize(id);
      Interface& entry = stored_.interfaces[id - 1];
      entry.id = InterfaceId(id);
      entry.left = RegionId(number(*left, c));
      entry.right = RegionId(number(*right, c));
      entry.kind = static_cast<InterfaceKind>(number(*kind, c) % 4);
      // The block of marked lines is named after the marker, that of the others after the
      // interface.
      if (entry.name.empty() || mark == 0) entry.name = block.name;
    }
    return true;
  }

  /// Notes where regions of a block have other values at points than `of_points`, which hold the
  /// largest of all blocks. To be called after add_regions() for all of them.
  void add_values_of_regions(const Block& block) {
    const DataSet& data = block.file.data;
    const NumberArray* global = data.array_of_points("GlobalNodeId");
    const NumberArray* region = data.array_of_cells("RegionId");
    if (global == nullptr || region == nullptr) return;
    region_values.resize(of_points.size());
    for (std::size_t k = 0; k < of_points.size(); ++k) {
      const PlaneField::Array& into = of_points[k];
      const NumberArray* from = data.array_of_points(into.name);
      if (from == nullptr) continue;
      const auto differs = [&](std::uint32_t p) {
        const double own = value(*from, p), largest = into.values[number(*global, p)];
        return own != largest && !(std::isnan(own) && std::isnan(largest));
      };
      std::array<std::uint32_t, 8> room{};
      for (std::size_t c = 0; c < data.cell_count(); ++c) {
        for (const std::uint32_t p : data.nodes(c, room).first(3))
          if (differs(p))
            region_values[k].push_back(
                {number(*global, p), RegionId(number(*region, c)), value(*from, p)});
      }
    }
  }

  /// To be called after the last block: midpoints left out.
  void finish() {
    TriangleSoup& soup = stored_.soup;
    for (PlaneField::Array& array : of_points) array.values.resize(soup.points.size(), kNoNumber);
    for (std::vector<RegionValue>& all : region_values) {
      std::stable_sort(all.begin(), all.end(), [](const RegionValue& a, const RegionValue& b) {
        return a.place() < b.place();
      });
      const auto is_same = [](const RegionValue& a, const RegionValue& b) {
        return a.place() == b.place();
      };
      all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
    }
    stored_.second_order = !midpoints_.empty();
    if (midpoints_.empty()) return;
    if (middles_.size() == soup.triangles.size()) {
      for (const auto& [a, b, c] : middles_)
        middles.push_back({soup.points[a], soup.points[b], soup.points[c]});
    }
    const std::vector<std::uint32_t> renumbered = drop_midpoints(midpoints_, soup);
    for (PlaneField::Array& array : of_points)
      drop_values(renumbered, soup.points.size(), array.values);
    for (std::vector<RegionValue>& all : region_values)
      for (RegionValue& one : all) one.vertex = renumbered[one.vertex];
    for (StoredEdge& edge : stored_.edges)
      edge = {renumbered[edge.a], renumbered[edge.b], edge.interface, edge.marker};
  }

 private:
  /// Takes the values of a block of regions. False if there are not as many as there should be.
  bool take_arrays_of_block() {
    for (CellArray& into : of_triangles) {
      const NumberArray* from = data_->array_of_cells(into.name);
      if (from == nullptr) return false;
      for (std::size_t c = 0; c < data_->cell_count(); ++c) into.values.push_back(value(*from, c));
    }
    for (PlaneField::Array& into : of_points) {
      const NumberArray* from = data_->array_of_points(into.name);
      if (from == nullptr) return false;
      into.values.resize(stored_.soup.points.size(), kNoNumber);
      for (std::size_t p = 0; p < data_->point_count(); ++p) {
        double& largest = into.values[number(*global_, p)];
        largest = larger_value(largest, value(*from, p));
      }
    }
    return true;
  }

  /// Takes the points of a block, which may be those of other blocks too.
  bool start(const DataSet& data) {
    data_ = &data;
    global_ = data.array_of_points("GlobalNodeId");
    if (global_ == nullptr) return data.point_count() == 0;
    has_periodic_points |= data.array_of_points("PeriodicNode") != nullptr;
    auto& points = stored_.soup.points;
    for (std::size_t p = 0; p < data.point_count(); ++p) {
      const std::uint32_t v = number(*global_, p);
      if (v > most_) return false;
      if (points.size() <= v) points.resize(v + std::size_t{1});
      const DataSet::Coordinates x = data.point(p);
      points[v] = {x[0], x[1]};
    }
    return true;
  }

  /// The nodes of a cell with `corners` corners, and maybe midpoints, into `nodes_`.
  bool take_nodes(std::size_t cell, std::size_t corners) {
    std::array<std::uint32_t, 8> room{};
    const auto nodes = data_->nodes(cell, room);
    if (nodes.size() < corners) return false;
    nodes_.clear();
    for (const std::uint32_t node : nodes) nodes_.push_back(number(*global_, node));
    midpoints_.insert(midpoints_.end(), nodes_.begin() + static_cast<std::ptrdiff_t>(corners),
                      nodes_.end());
    return true;
  }

  static double value(const NumberArray& array, std::size_t k) {
    return array.visit([k](auto numbers) { return static_cast<double>(numbers[k]); });
  }
  /// A number that is not one becomes one that is too large.
  [[nodiscard]] std::uint32_t number(const NumberArray& array, std::size_t k) const {
    const double found = value(array, k);
    return found >= 0 && found <= most_ ? static_cast<std::uint32_t>(found) : most_ + 1;
  }

  StoredMesh& stored_;
  std::uint32_t most_;
  const DataSet* data_ = nullptr;
  const NumberArray* global_ = nullptr;
  std::vector<std::uint32_t> nodes_;
  std::vector<std::uint32_t> midpoints_;
  std::vector<std::array<std::uint32_t, 3>> middles_;  ///< of triangles with six nodes
};

}  // namespace

StoredMesh VtmMesh::finish(std::vector<std::string>& notes) && {
  notes = take_arrays(std::move(of_triangles), std::move(of_points), words, mesh, true,
                      std::move(region_values));
  sort_by_region(mesh.soup);
  return std::move(mesh);
}

Result<VtmMesh> read_vtm(const std::string& path) {
  BlockFiles reader(path);
  const Result<std::vector<Block>> files = reader.read();
  if (!files) return files.error();
  std::size_t most = 0;
  for (const Block& block : *files)
    most += block.file.data.point_count() + block.file.data.cell_count();
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max() - 1;
  VtmMesh out;
  StoredMesh& stored = out.mesh;
  BlockReader blocks(stored, static_cast<std::uint32_t>(std::min(most, kMost)));
  blocks.expect_arrays(*files);
  const auto lacks = [&](const Block& block) {
    return wrong_file(path, fmt::format("block {}/{} lacks what cover writes", legible(block.group),
                                        legible(block.name)));
  };
  for (const Block& block : *files)
    if (block.group == "regions" && !blocks.add_regions(block)) return lacks(block);
  for (const Block& block : *files)
    if (block.group == "regions") blocks.add_values_of_regions(block);
  for (const Block& block : *files)
    if (block.group == "interfaces" && !blocks.add_lines(block)) return lacks(block);
  blocks.finish();
  if (reader.names()) take_names(*reader.names(), stored);
  if (stored.regions.empty()) return wrong_file(path, "no regions in it: not written by cover");
  out.of_triangles = std::move(blocks.of_triangles);
  out.of_points = std::move(blocks.of_points);
  out.region_values = std::move(blocks.region_values);
  out.middles = std::move(blocks.middles);
  out.has_periodic_points = blocks.has_periodic_points;
  out.has_names = reader.names().has_value();
  if (reader.names()) {
    out.words = words_of(*reader.names());
    sort_arrays(attributes_of(*reader.names()), out.of_triangles);
  }
  return out;
}

Result<StoredMesh> read_vtm_origin(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  const Result<XmlTree> tree = parse_xml(*text, path);
  if (!tree) return tree.error();
  StoredMesh stored;
  if (const XmlElement* names = tree->root.child("CoverNames")) {
    stored.regions.resize(static_cast<std::size_t>(
        std::count_if(names->children.begin(), names->children.end(),
                      [](const XmlElement& element) { return element.name == "Region"; })));
    take_names(*names, stored);
  }
  return stored;
}

Result<MeshFile> read_vtm_mesh(const std::string& path) {
  Result<VtmMesh> blocks = read_vtm(path);
  if (!blocks) return std::move(blocks).error();
  MeshFile file;
  file.second_order = blocks->mesh.second_order;
  file.cut_vertices = blocks->mesh.cut_vertices;
  file.has_periodic_points = blocks->has_periodic_points;
  file.named_points = std::move(blocks->mesh.points);
  file.point_arrays = std::move(blocks->of_points);
  for (const StoredEdge& edge : blocks->mesh.edges)
    file.lines.push_back({edge.a, edge.b, edge.interface.value(), edge.marker});
  for (const Interface& line : blocks->mesh.interfaces)
    if (!line.name.empty()) file.line_names.emplace(line.id.value(), line.name);
  const auto& region = blocks->mesh.soup.region;
  const auto order = sorted_numbers<std::size_t>(
      region.size(), [&](std::size_t a, std::size_t b) { return region[a] < region[b]; });
  if (!blocks->middles.empty()) file.middles = in_order(blocks->middles, order);
  for (CellArray& array : blocks->of_triangles) {
    array.values = in_order(array.values, order);
    file.arrays.push_back(std::move(array));
  }
  file.soup = std::move(blocks->mesh.soup);
  sort_by_region(file.soup);
  return file;
}

}  // namespace cover
