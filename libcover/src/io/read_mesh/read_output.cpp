// Triangles come from the mesh; names and lines from the manifest or the .vtm beside it, since most
// formats cannot hold them all; else what the file itself has is made the best of.
// Tested by tests/unit/vtk/read_output_test.cpp.
#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>

#include "base/errors.hpp"
#include "base/out_of_memory.hpp"
#include "io/read_mesh/complete_mesh.hpp"
#include "io/read_mesh/read_vtkhdf_mesh.hpp"
#include "io/read_mesh/second_order.hpp"
#include "io/text/text.hpp"
#include "io/text/xml_tree.hpp"
#include "io/vtk_files/read_data_set.hpp"
#include "io/vtk_files/whole_number.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

/// One block of a group: a grid and its name.
struct Block {
  std::string group;
  std::string name;
  DataSetFile file;
};

/// The files that a .vtm names, read: those of `<Block name="...">` and no deeper.
class BlockFiles {
 public:
  explicit BlockFiles(const std::string& path) : path_(path) {}

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
    // The pieces are beside the file that a link leads to.
    std::error_code ignored;
    const fs::path canonical = fs::canonical(path_, ignored);
    const fs::path piece = (ignored ? fs::path(path_) : canonical).parent_path() / file;
    // Else a small file could name a large one a thousand times.
    if (!seen_.insert(piece.lexically_normal()).second)
      return wrong_file(path_, fmt::format("two blocks have the file '{}'", legible(file)));
    if (!fs::is_regular_file(piece))
      return Error{ErrorCode::cannot_open,
                   fmt::format("{}: there is no file '{}' of a block", path_, legible(file)),
                   {},
                   {}};
    Result<DataSetFile> data = read_data_set(piece);
    if (!data) return std::move(data).error();
    blocks_.push_back({std::string(group), std::string(element.value("name")), std::move(*data)});
    return ok();
  }

  const std::string& path_;
  std::set<fs::path> seen_;
  std::vector<Block> blocks_;
  std::optional<XmlElement> names_;
};

/// Takes over the names and the origin; those of regions and lines that are not there are left.
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
  for (const XmlElement& element : names.children) {
    if (element.name == "Option")
      stored.provenance.settings.push_back({text(element, "Name"), text(element, "Value")});
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

/// Gathers the blocks of a .vtm into one mesh again, by the numbers that vertices have in it.
class BlockReader {
 public:
  /// `most` is above any number of a vertex, a region or an interface: what the blocks have in all.
  BlockReader(StoredMesh& stored, std::uint32_t most) : stored_(stored), most_(most) {}

  /// False if an array that write_vtm() writes is missing.
  bool add_regions(const Block& block) {
    if (!start(block.file.data)) return false;
    const NumberArray* region = data_->array_of_cells("RegionId");
    const NumberArray* material = data_->array_of_cells("material");
    if (region == nullptr || material == nullptr) return false;
    for (std::size_t c = 0; c < data_->cell_count(); ++c) {
      if (!take_nodes(c, 3)) return false;
      const std::uint32_t id = number(*region, c);
      if (id == 0 || id > most_) return false;
      const int of_material = static_cast<int>(number(*material, c));
      stored_.soup.triangles.push_back({nodes_[0], nodes_[1], nodes_[2]});
      stored_.soup.region.push_back(id);
      stored_.soup.material.push_back(of_material);
      if (stored_.regions.size() < id) stored_.regions.resize(id);
      Region& entry = stored_.regions[id - 1];
      if (entry.material != 0) continue;
      entry.id = RegionId(id);
      entry.material = of_material;
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

  /// To be called after the last block: triangles in their order again, midpoints left out.
  void finish() {
    TriangleSoup& soup = stored_.soup;
    sort_by_region(soup);
    stored_.second_order = !midpoints_.empty();
    if (midpoints_.empty()) return;
    const std::vector<std::uint32_t> renumbered = drop_midpoints(midpoints_, soup);
    for (StoredEdge& edge : stored_.edges)
      edge = {renumbered[edge.a], renumbered[edge.b], edge.interface, edge.marker};
  }

 private:
  /// Takes the points of a block, which may be those of other blocks too.
  bool start(const DataSet& data) {
    data_ = &data;
    global_ = data.array_of_points("GlobalNodeId");
    if (global_ == nullptr) return data.point_count() == 0;
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
};

Result<StoredMesh> read_vtm(const std::string& path) {
  BlockFiles reader(path);
  const Result<std::vector<Block>> files = reader.read();
  if (!files) return files.error();
  std::size_t most = 0;
  for (const Block& block : *files)
    most += block.file.data.point_count() + block.file.data.cell_count();
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max() - 1;
  StoredMesh stored;
  BlockReader blocks(stored, static_cast<std::uint32_t>(std::min(most, kMost)));
  const auto lacks = [&](const Block& block) {
    return wrong_file(path, fmt::format("block {}/{} lacks what cover writes", legible(block.group),
                                        legible(block.name)));
  };
  for (const Block& block : *files)
    if (block.group == "regions" && !blocks.add_regions(block)) return lacks(block);
  for (const Block& block : *files)
    if (block.group == "interfaces" && !blocks.add_lines(block)) return lacks(block);
  blocks.finish();
  if (reader.names()) take_names(*reader.names(), stored);
  if (stored.regions.empty()) return wrong_file(path, "no regions in it: not written by cover");
  return stored;
}

/// Names and lines for the triangles of `stored` out of the .vtm of the same mesh.
Status take_names_from_vtm(const std::string& path, StoredMesh& stored) {
  Result<StoredMesh> named = read_vtm(path);
  if (!named) return std::move(named).error();
  if (named->soup.points != stored.soup.points) return wrong_file(path, "it is of another mesh");
  stored.regions = std::move(named->regions);
  stored.interfaces = std::move(named->interfaces);
  stored.edges = std::move(named->edges);
  stored.provenance = std::move(named->provenance);
  stored.unit = std::move(named->unit);
  stored.scale = named->scale;
  stored.input_vertices = named->input_vertices;
  return take_materials(stored) ? ok() : Status(wrong_file(path, "it is of another mesh"));
}

/// What a mesh's own file and those beside it hold.
class Completion {
 public:
  explicit Completion(const std::string& path) : path_(path) {}

  /// A note on what stays unknown, or nothing.
  [[nodiscard]] const std::string& missing() const { return missing_; }

  Result<StoredMesh> read() {
    if (extension_of(path_) == ".vtm") return read_blocks();
    if (extension_of(path_) == ".vtkhdf") {
      Result<VtkHdfMesh> file = read_vtkhdf_mesh(path_);
      if (!file) return std::move(file).error();
      return file->has_names ? read_named(*std::move(file)) : complete(std::move(file->mesh));
    }
    Result<MeshFile> file = read_mesh(path_);
    return file ? complete(*std::move(file)) : std::move(file).error();
  }

 private:
  [[nodiscard]] std::string beside(const char* extension) const {
    return fs::path(path_).replace_extension(extension);
  }

  /// A file that holds all that cover knows.
  Result<StoredMesh> read_named(VtkHdfMesh file) const {
    StoredMesh stored = std::move(file.names);
    stored.soup = std::move(file.mesh.soup);
    stored.second_order = file.mesh.second_order;
    for (const MeshLine& line : file.mesh.lines) {
      if (line.group < 1 || line.group > static_cast<std::int64_t>(stored.interfaces.size()))
        return wrong_file(path_, fmt::format("there is no interface {}", line.group));
      stored.edges.push_back(
          {line.a, line.b, InterfaceId(static_cast<std::uint32_t>(line.group)), line.marker});
    }
    if (!take_materials(stored)) return wrong_file(path_, "it lacks regions");
    sort_by_region(stored.soup);
    return stored;
  }

  Result<StoredMesh> complete(MeshFile read) {
    const MeshFile* file = &read;
    StoredMesh stored;
    stored.soup = file->soup;
    stored.second_order = file->second_order;
    Result<bool> named = read_manifest(beside(".json"), file->group, stored);
    if (!named) return std::move(named).error();
    if (!*named && fs::is_regular_file(beside(".vtm")) && !stored.soup.region.empty()) {
      if (Status status = take_names_from_vtm(beside(".vtm"), stored); !status)
        return std::move(status).error();
    } else if (!*named) {
      if (Status status = complete_alone(*file, stored); !status) return std::move(status).error();
    }
    sort_by_region(stored.soup);
    return stored;
  }

  Result<StoredMesh> read_blocks() const {
    Result<StoredMesh> stored = read_vtm(path_);
    if (!stored) return stored;
    const Result<bool> named = read_manifest(beside(".json"), {}, *stored);
    return named ? std::move(stored) : named.error();
  }

  Status complete_alone(const MeshFile& file, StoredMesh& stored) {
    // Medit's format and those that have groups alone cannot tell regions; all others do.
    const bool tells_regions = file.group.empty() && extension_of(path_) != ".mesh";
    if (stored.soup.region.empty() && tells_regions)
      return wrong_file(path_, "no RegionId of its triangles: not a mesh that cover wrote");
    const std::string unknown = complete_from_file(file, stored);
    if (!unknown.empty()) {
      missing_ = fmt::format("{} holds no {}, and neither {} nor {} is there: they are made up",
                             path_, unknown, beside(".json"), beside(".vtm"));
    }
    return ok();
  }

  std::string path_;
  std::string missing_;
};

}  // namespace

Result<Output> read_output(const std::string& path) {
  return memory_as_value(path, [&]() -> Result<Output> {
    Completion completion(path);
    Result<StoredMesh> stored = completion.read();
    if (!stored) return std::move(stored).error();
    Result<Output> output = rebuild(*stored);
    if (!output && output.error().code == ErrorCode::out_of_memory) return output;
    if (!output) return wrong_file(path, output.error().message);
    const auto warn = [&](std::string message) {
      output->report.notes.push_back({Note::Kind::warning, kVoid, std::move(message), {}});
    };
    if (!completion.missing().empty()) warn(completion.missing());
    if (stored->second_order) {
      warn(fmt::format("{}: triangles have six nodes, of which the corners are taken", path));
    }
    return output;
  });
}

}  // namespace cover
