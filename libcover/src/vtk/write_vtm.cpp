// A block per group of regions and per group of lines, under the names that people see in ParaView
// and that .msh has for its physical groups: whoever extracts the block SiO2 gets all of it. VTK
// writes X.vtm and its pieces X/X_*.vtu into a folder beside the target; then both are moved to
// their places, the pieces first. What an earlier run left there is replaced.
#include <cover/write_mesh.hpp>

#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include "io/mesh_view.hpp"
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

vtkSmartPointer<vtkMultiBlockDataSet> region_blocks(const MeshView& view) {
  const Buckets members(view.region_groups.size(), view.triangles.size(), [&](std::size_t t) {
    return view.region_group[view.region[t].index() - 1];
  });
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t g = 0; g < members.size(); ++g)
    append(blocks, grid_of_triangles(view, members[g]), view.region_groups[g].name);
  return blocks;
}

vtkSmartPointer<vtkMultiBlockDataSet> line_blocks(const MeshView& view, const RegionTable& table) {
  const Buckets members(view.line_groups.size(), view.lines.size(),
                        [&](std::size_t l) { return view.line_group[l]; });
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t g = 0; g < members.size(); ++g) {
    // Sides of the hull are on no interface, and all in one group.
    if (view.interface[members[g].front()] != kNoInterface)
      append(blocks, grid_of_lines(view, table, members[g]), view.line_groups[g].name);
  }
  return blocks;
}

bool write_blocks(const Output& output, const WriteOptions& options, const fs::path& file) {
  WriteOptions all = options;
  all.inner_lines = true;
  const MeshView view = view_of(output, all);
  vtkNew<vtkMultiBlockDataSet> root;
  append(root, region_blocks(view), "regions");
  append(root, line_blocks(view, output.table), "interfaces");
  const QuietVtk quiet;
  vtkNew<vtkXMLMultiBlockDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(root);
  set_encoding(writer);
  return writer->Write() != 0;
}

}  // namespace

Status write_vtm(const Output& output, const std::string& path, const WriteOptions& options) {
  const fs::path target(path);
  const auto failure = [&](const std::string& why) {
    return Error{ErrorCode::cannot_write, fmt::format("cannot write {}{}", path, why), {}, {}};
  };
  Result<ScratchFolder> scratch = ScratchFolder::beside(path);
  if (!scratch) return std::move(scratch).error();
  const fs::path file = scratch->path() / target.filename();
  if (!write_blocks(output, options, file)) return failure("");

  const fs::path pieces = fs::path(target).replace_extension();
  std::error_code code;
  if (fs::is_directory(pieces)) fs::rename(pieces, scratch->path() / "before", code);
  if (!code) fs::rename(fs::path(file).replace_extension(), pieces, code);
  if (!code) fs::rename(file, target, code);
  if (code) return failure(": " + code.message());
  return ok();
}

}  // namespace cover
