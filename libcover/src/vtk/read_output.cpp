// Triangles come from the mesh; names and lines from the manifest or the .vtm beside it, since most
// formats cannot hold them all; else what the file itself has is made the best of.
// Tested by tests/unit/vtk/read_output_test.cpp.
#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/core.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLMultiBlockDataReader.h>

#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>

#include "base/errors.hpp"
#include "io/read_mesh/complete_mesh.hpp"
#include "io/read_mesh/second_order.hpp"
#include "io/report/read_manifest.hpp"
#include "vtk/cell_values.hpp"
#include "vtk/quiet_vtk.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

/// One block: a grid and its name.
struct Block {
  std::string name;
  vtkSmartPointer<vtkUnstructuredGrid> grid;
};

std::vector<Block> blocks_of(vtkMultiBlockDataSet& root, const std::string& group_name) {
  std::vector<Block> blocks;
  for (unsigned g = 0; g < root.GetNumberOfBlocks(); ++g) {
    auto* group = vtkMultiBlockDataSet::SafeDownCast(root.GetBlock(g));
    const char* name = root.GetMetaData(g)->Get(vtkCompositeDataSet::NAME());
    if (group == nullptr || name == nullptr || name != group_name) continue;
    for (unsigned k = 0; k < group->GetNumberOfBlocks(); ++k) {
      const char* own = group->GetMetaData(k)->Get(vtkCompositeDataSet::NAME());
      blocks.push_back(
          {own == nullptr ? "" : own, vtkUnstructuredGrid::SafeDownCast(group->GetBlock(k))});
    }
  }
  return blocks;
}

/// Gathers the blocks of a .vtm into one mesh again, by the numbers that vertices have in it.
class BlockReader {
 public:
  /// `most` is above any number of a vertex, a region or an interface: what the blocks have in all.
  BlockReader(StoredMesh& stored, std::uint32_t most) : stored_(stored), most_(most) {}

  /// False if an array that write_vtm() writes is missing.
  bool add_regions(const Block& block) {
    if (!block.grid || !start(*block.grid)) return false;
    vtkDataArray* region = array("RegionId");
    vtkDataArray* material = array("material");
    if (region == nullptr || material == nullptr) return false;
    for (vtkIdType c = 0; c < grid_->GetNumberOfCells(); ++c) {
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
    if (!block.grid || !start(*block.grid)) return false;
    vtkDataArray* line = array("LineID");
    vtkDataArray* left = array("LeftRegion");
    vtkDataArray* right = array("RightRegion");
    vtkDataArray* kind = array("LineKind");
    vtkDataArray* marker = array("marker");
    if (line == nullptr || left == nullptr || right == nullptr || kind == nullptr ||
        marker == nullptr)
      return false;
    for (vtkIdType c = 0; c < grid_->GetNumberOfCells(); ++c) {
      if (!take_nodes(c, 2)) return false;
      const std::uint32_t id = number(*line, c);
      if (id == 0 || id > most_) return false;
      const int mark = static_cast<int>(whole_number(marker->GetTuple1(c)));
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
  bool start(vtkUnstructuredGrid& grid) {
    grid_ = &grid;
    global_ = grid.GetPointData()->GetArray("GlobalNodeId");
    if (global_ == nullptr || global_->GetNumberOfComponents() != 1 ||
        global_->GetNumberOfTuples() != grid.GetNumberOfPoints())
      return false;
    auto& points = stored_.soup.points;
    for (vtkIdType p = 0; p < grid.GetNumberOfPoints(); ++p) {
      const std::uint32_t v = number(*global_, p);
      if (v > most_) return false;
      if (points.size() <= v) points.resize(v + 1);
      points[v] = {grid.GetPoint(p)[0], grid.GetPoint(p)[1]};
    }
    return true;
  }

  /// The nodes of a cell with `corners` corners, and maybe midpoints, into `nodes_`.
  bool take_nodes(vtkIdType cell, vtkIdType corners) {
    grid_->GetCellPoints(cell, ids_);
    const vtkIdType n = ids_->GetNumberOfIds();
    if (n < corners) return false;
    nodes_.clear();
    for (vtkIdType k = 0; k < n; ++k) {
      const vtkIdType node = ids_->GetId(k);
      if (node < 0 || node >= grid_->GetNumberOfPoints()) return false;
      nodes_.push_back(number(*global_, node));
    }
    midpoints_.insert(midpoints_.end(), nodes_.begin() + corners, nodes_.end());
    return true;
  }

  /// A number that is not one becomes one that is too large.
  [[nodiscard]] std::uint32_t number(vtkDataArray& array, vtkIdType k) const {
    const double value = array.GetTuple1(k);
    return value >= 0 && value <= most_ ? static_cast<std::uint32_t>(value) : most_ + 1;
  }
  [[nodiscard]] vtkDataArray* array(const char* name) const {
    vtkDataArray* found = grid_->GetCellData()->GetArray(name);
    return is_one_per_cell(found, *grid_) ? found : nullptr;
  }

  StoredMesh& stored_;
  std::uint32_t most_;
  vtkUnstructuredGrid* grid_ = nullptr;
  vtkDataArray* global_ = nullptr;
  vtkNew<vtkIdList> ids_;
  std::vector<std::uint32_t> nodes_;
  std::vector<std::uint32_t> midpoints_;
};

Result<StoredMesh> read_vtm(const std::string& path) {
  if (!fs::is_regular_file(path)) {
    return Error{ErrorCode::cannot_open, fmt::format("cannot open '{}'", path), {}, {}};
  }
  const QuietVtk quiet;
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  // The pieces are beside the file that a link leads to.
  std::error_code ignored;
  const fs::path file = fs::canonical(path, ignored);
  reader->SetFileName((ignored ? path : file.string()).c_str());
  reader->Update();
  auto* root = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (reader->GetErrorCode() != 0 || root == nullptr) return wrong_file(path, "not a valid VTK file");
  StoredMesh stored;
  BlockReader blocks(
      stored, static_cast<std::uint32_t>(root->GetNumberOfPoints() + root->GetNumberOfCells()));
  for (const Block& block : blocks_of(*root, "regions")) {
    if (!blocks.add_regions(block)) {
      return wrong_file(path, fmt::format("block regions/{} lacks what cover writes", block.name));
    }
  }
  for (const Block& block : blocks_of(*root, "interfaces")) {
    if (!blocks.add_lines(block)) {
      return wrong_file(path, fmt::format("block interfaces/{} lacks what cover writes", block.name));
    }
  }
  blocks.finish();
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
  return take_materials(stored) ? ok() : Status(wrong_file(path, "it is of another mesh"));
}

/// What a mesh's own file and those beside it hold.
class Completion {
 public:
  explicit Completion(const std::string& path) : path_(path) {}

  /// A note on what stays unknown, or nothing.
  [[nodiscard]] const std::string& missing() const { return missing_; }

  Result<StoredMesh> read() {
    if (fs::path(path_).extension() == ".vtm") return read_blocks();
    Result<MeshFile> file = read_mesh(path_);
    if (!file) return std::move(file).error();
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

 private:
  [[nodiscard]] std::string beside(const char* extension) const {
    return fs::path(path_).replace_extension(extension);
  }

  Result<StoredMesh> read_blocks() const {
    Result<StoredMesh> stored = read_vtm(path_);
    if (!stored) return stored;
    const Result<bool> named = read_manifest(beside(".json"), {}, *stored);
    return named ? std::move(stored) : named.error();
  }

  Status complete_alone(const MeshFile& file, StoredMesh& stored) {
    // Medit's format and those that have groups alone cannot tell regions; all others do.
    const bool tells_regions = file.group.empty() && fs::path(path_).extension() != ".mesh";
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
  Completion completion(path);
  Result<StoredMesh> stored = completion.read();
  if (!stored) return std::move(stored).error();
  Result<Output> output = rebuild(*stored);
  if (!output) return wrong_file(path, output.error().message);
  const auto warn = [&](std::string message) {
    output->report.notes.push_back({Note::Kind::warning, kVoid, std::move(message), {}});
  };
  if (!completion.missing().empty()) warn(completion.missing());
  if (stored->second_order) {
    warn(fmt::format("{}: triangles have six nodes, of which the corners are taken", path));
  }
  return output;
}

}  // namespace cover
