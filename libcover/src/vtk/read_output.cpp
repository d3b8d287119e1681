// Triangles come from the mesh; names and lines from the manifest or the .vtm beside it, since a
// .vtu cannot hold them in a way that every reader takes. Tested by
// tests/unit/vtk/read_output_test.cpp.
#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
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

#include "io/read_manifest.hpp"
#include "vtk/quiet_vtk.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

Error wrong(const std::string& path, std::string_view what) {
  return {ErrorCode::syntax, fmt::format("{}: {}", path, what), {}, {}};
}

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
  explicit BlockReader(StoredMesh& stored) : stored_(stored) {}

  /// False if an array that write_vtm() writes is missing.
  bool add_region(const Block& block) {
    if (!block.grid || !start(*block.grid)) return false;
    vtkDataArray* region = array("RegionId");
    vtkDataArray* material = array("material");
    if (region == nullptr || material == nullptr || block.grid->GetNumberOfCells() == 0)
      return false;
    Region entry;
    entry.id = RegionId(static_cast<std::uint32_t>(region->GetTuple1(0)));
    entry.material = static_cast<int>(material->GetTuple1(0));
    entry.name = block.name;
    entry.material_name = fmt::format("material_{}", entry.material);
    stored_.regions.push_back(entry);
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < grid_->GetNumberOfCells(); ++c) {
      grid_->GetCellPoints(c, ids);
      if (ids->GetNumberOfIds() != 3) return false;
      stored_.soup.triangles.push_back(
          {vertex(ids->GetId(0)), vertex(ids->GetId(1)), vertex(ids->GetId(2))});
      stored_.soup.region.push_back(entry.id.value());
      stored_.soup.material.push_back(entry.material);
    }
    return true;
  }

  bool add_interface(const Block& block) {
    if (!block.grid || !start(*block.grid)) return false;
    vtkDataArray* left = array("LeftRegion");
    vtkDataArray* right = array("RightRegion");
    vtkDataArray* kind = array("LineKind");
    vtkDataArray* marker = array("marker");
    if (left == nullptr || right == nullptr || kind == nullptr || marker == nullptr) return false;
    Interface line;
    line.id = InterfaceId(stored_.interfaces.size() + 1);
    line.name = block.name;
    if (grid_->GetNumberOfCells() > 0) {
      line.left = RegionId(static_cast<std::uint32_t>(left->GetTuple1(0)));
      line.right = RegionId(static_cast<std::uint32_t>(right->GetTuple1(0)));
      line.kind = static_cast<InterfaceKind>(static_cast<int>(kind->GetTuple1(0)));
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < grid_->GetNumberOfCells(); ++c) {
      grid_->GetCellPoints(c, ids);
      if (ids->GetNumberOfIds() != 2) return false;
      stored_.edges.push_back({vertex(ids->GetId(0)), vertex(ids->GetId(1)), line.id,
                               static_cast<int>(marker->GetTuple1(c))});
    }
    stored_.interfaces.push_back(std::move(line));
    return true;
  }

 private:
  /// Takes the points of a block, which may be those of other blocks too.
  bool start(vtkUnstructuredGrid& grid) {
    grid_ = &grid;
    global_ = grid.GetPointData()->GetArray("GlobalNodeId");
    if (global_ == nullptr || global_->GetNumberOfTuples() != grid.GetNumberOfPoints())
      return false;
    auto& points = stored_.soup.points;
    for (vtkIdType p = 0; p < grid.GetNumberOfPoints(); ++p) {
      const double number = global_->GetTuple1(p);
      if (!(number >= 0 && number < 1e9)) return false;
      const std::size_t v = vertex(p);
      if (points.size() <= v) points.resize(v + 1);
      points[v] = {grid.GetPoint(p)[0], grid.GetPoint(p)[1]};
    }
    return true;
  }

  [[nodiscard]] std::uint32_t vertex(vtkIdType p) const {
    return static_cast<std::uint32_t>(global_->GetTuple1(p));
  }
  [[nodiscard]] vtkDataArray* array(const char* name) const {
    return grid_->GetCellData()->GetArray(name);
  }

  StoredMesh& stored_;
  vtkUnstructuredGrid* grid_ = nullptr;
  vtkDataArray* global_ = nullptr;
};

Result<StoredMesh> read_vtm(const std::string& path) {
  if (!fs::is_regular_file(path)) {
    return Error{ErrorCode::cannot_open, fmt::format("cannot open '{}'", path), {}, {}};
  }
  const QuietVtk quiet;
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* root = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (reader->GetErrorCode() != 0 || root == nullptr) return wrong(path, "not a valid VTK file");
  StoredMesh stored;
  BlockReader blocks(stored);
  for (const Block& block : blocks_of(*root, "regions")) {
    if (!blocks.add_region(block)) {
      return wrong(path, fmt::format("block regions/{} lacks what cover writes", block.name));
    }
  }
  for (const Block& block : blocks_of(*root, "interfaces")) {
    if (!blocks.add_interface(block)) {
      return wrong(path, fmt::format("block interfaces/{} lacks what cover writes", block.name));
    }
  }
  std::sort(stored.regions.begin(), stored.regions.end(),
            [](const Region& a, const Region& b) { return a.id < b.id; });
  if (stored.regions.empty()) return wrong(path, "no regions in it: not written by cover");
  return stored;
}

Result<StoredMesh> read_triangles(const std::string& path) {
  Result<MeshFile> file = read_mesh(path);
  if (!file) return std::move(file).error();
  if (file->soup.region.empty()) {
    return wrong(path, "no cell array RegionId: not a mesh that cover wrote");
  }
  StoredMesh stored;
  stored.soup = std::move(file->soup);
  if (stored.soup.material.empty()) stored.soup.material = stored.soup.region;
  return stored;
}

/// Names and lines for the triangles of `stored` out of the .vtm of the same mesh.
Status take_names_from_vtm(const std::string& path, StoredMesh& stored) {
  Result<StoredMesh> named = read_vtm(path);
  if (!named) return std::move(named).error();
  if (named->soup.points != stored.soup.points) return wrong(path, "it is of another mesh");
  stored.regions = std::move(named->regions);
  stored.interfaces = std::move(named->interfaces);
  stored.edges = std::move(named->edges);
  return ok();
}

/// Looks beside the mesh for what it cannot hold; returns what stays unknown.
Result<std::string> complete(const std::string& path, StoredMesh& stored) {
  const fs::path manifest = fs::path(path).replace_extension(".json");
  const fs::path vtm = fs::path(path).replace_extension(".vtm");
  const Result<bool> named = read_manifest(manifest, stored);
  if (!named) return named.error();
  if (*named) return std::string();
  if (!stored.regions.empty()) return std::string();
  if (fs::is_regular_file(vtm)) {
    Status status = take_names_from_vtm(vtm, stored);
    if (!status) return std::move(status).error();
    return std::string();
  }
  return fmt::format(
      "{} holds no names, contacts and boundary markers, and neither {} nor {} is "
      "there: regions are named after their materials, lines after their regions",
      path, manifest.string(), vtm.string());
}

}  // namespace

Result<Output> read_output(const std::string& path) {
  Result<StoredMesh> stored =
      fs::path(path).extension() == ".vtm" ? read_vtm(path) : read_triangles(path);
  if (!stored) return std::move(stored).error();
  Result<std::string> missing = complete(path, *stored);
  if (!missing) return std::move(missing).error();
  Result<Output> output = rebuild(*stored);
  if (!output) return wrong(path, output.error().message);
  if (!missing->empty()) {
    output->report.notes.push_back({Note::Kind::warning, kVoid, *missing, {}});
  }
  return output;
}

}  // namespace cover
