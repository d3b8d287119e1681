// A block per region and per interface, under the names that people see in ParaView. VTK writes
// X.vtm and its pieces X/X_*.vtu into a folder beside the target; then both are moved to their
// places, the pieces first. What an earlier run left there is replaced.
#include <cover/write_mesh.hpp>

#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include "base/safe_names.hpp"
#include "io/scratch_folder.hpp"
#include "vtk/grid.hpp"
#include "vtk/quiet_vtk.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

void append(vtkMultiBlockDataSet* blocks, vtkDataObject* block, const std::string& name) {
  const unsigned k = blocks->GetNumberOfBlocks();
  blocks->SetBlock(k, block);
  blocks->GetMetaData(k)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

template <class Items>
std::vector<std::string> block_names(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return unique_safe_names(names);
}

vtkSmartPointer<vtkMultiBlockDataSet> region_blocks(const Output& output) {
  const Mesh& mesh = output.mesh;
  std::vector<std::vector<TriMesh::FaceHandle>> faces(output.table.regions.size());
  for (const auto f : mesh.tri().faces()) faces[mesh.region(f).index() - 1].push_back(f);
  const std::vector<std::string> names = block_names(output.table.regions);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t r = 0; r < faces.size(); ++r) {
    append(blocks, grid_of_region(mesh, faces[r]), names[r]);
  }
  return blocks;
}

vtkSmartPointer<vtkMultiBlockDataSet> interface_blocks(const Output& output) {
  const Mesh& mesh = output.mesh;
  std::vector<std::vector<TriMesh::EdgeHandle>> edges(output.table.interfaces.size());
  for (const auto e : mesh.tri().edges()) {
    const InterfaceId id = mesh.interface(e);
    if (id != kNoInterface) edges[id.index() - 1].push_back(e);
  }
  const std::vector<std::string> names = block_names(output.table.interfaces);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    append(blocks, grid_of_interface(mesh, output.table.interfaces[i], edges[i]), names[i]);
  }
  return blocks;
}

bool write_blocks(const Output& output, const fs::path& file) {
  vtkNew<vtkMultiBlockDataSet> root;
  append(root, region_blocks(output), "regions");
  append(root, interface_blocks(output), "interfaces");
  const QuietVtk quiet;
  vtkNew<vtkXMLMultiBlockDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(root);
  set_encoding(writer);
  return writer->Write() != 0;
}

}  // namespace

Status write_vtm(const Output& output, const std::string& path) {
  const fs::path target(path);
  const auto failure = [&](const std::string& why) {
    return Error{ErrorCode::cannot_write, fmt::format("cannot write {}{}", path, why), {}, {}};
  };
  Result<ScratchFolder> scratch = ScratchFolder::beside(path);
  if (!scratch) return std::move(scratch).error();
  const fs::path file = scratch->path() / target.filename();
  if (!write_blocks(output, file)) return failure("");

  const fs::path pieces = fs::path(target).replace_extension();
  std::error_code code;
  if (fs::is_directory(pieces)) fs::rename(pieces, scratch->path() / "before", code);
  if (!code) fs::rename(fs::path(file).replace_extension(), pieces, code);
  if (!code) fs::rename(file, target, code);
  if (code) return failure(": " + code.message());
  return ok();
}

}  // namespace cover
