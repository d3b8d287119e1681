// A block per group of regions and per group of lines, under the names that people see in ParaView
// and that .msh has for its physical groups: whoever extracts the block SiO2 gets all of it. VTK
// writes X.vtm and its pieces X/X_0.vtu, ... into a folder beside the target; then they are moved
// to their places, the pieces first, all or none. The pieces of an earlier X.vtm are replaced;
// whatever else is in X/ is not ours and stays. Tested by tests/unit/vtk/write_vtk_test.cpp.
#include <cover/write_mesh.hpp>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include "io/files/scratch_folder.hpp"
#include "io/write_mesh/mesh_view.hpp"
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

/// Files that are moved one after the other, and moved back unless all went well.
class Moves {
 public:
  Moves() = default;
  Moves(const Moves&) = delete;
  Moves& operator=(const Moves&) = delete;

  /// Does nothing after a failure.
  void move(const fs::path& from, const fs::path& to) {
    if (code_) return;
    fs::rename(from, to, code_);
    if (!code_) done_.emplace_back(from, to);
  }
  void fail(std::error_code code) {
    if (!code_) code_ = code;
  }
  [[nodiscard]] const std::error_code& failure() const { return code_; }

  /// Whether everything is where it was.
  bool undo() {
    std::error_code code;
    for (; !done_.empty() && !code; done_.pop_back())
      fs::rename(done_.back().second, done_.back().first, code);
    return !code;
  }

 private:
  std::vector<std::pair<fs::path, fs::path>> done_;
  std::error_code code_;
};

/// Whether VTK gives this name to a piece of `stem`.vtm.
bool is_piece(std::string_view name, const std::string& stem) {
  const std::string head = stem + '_', tail = ".vtu";
  if (!name.starts_with(head) || !name.ends_with(tail)) return false;
  if (name.size() <= head.size() + tail.size()) return false;
  name = name.substr(head.size(), name.size() - head.size() - tail.size());
  return std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The pieces in a folder; none where there is no folder.
std::vector<fs::path> pieces_in(const fs::path& folder, const std::string& stem) {
  std::vector<fs::path> pieces;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (is_piece(entry.path().filename().string(), stem)) pieces.push_back(entry.path().filename());
  return pieces;
}

/// Moves what VTK wrote into `scratch` to the target.
Status put_into_place(ScratchFolder& scratch, const fs::path& target) {
  const auto failure = [&](const std::string& why) {
    return Error{
        ErrorCode::cannot_write, fmt::format("cannot write {}: {}", target.string(), why), {}, {}};
  };
  const fs::path file = scratch.path() / target.filename();
  const fs::path written = fs::path(file).replace_extension();
  const fs::path folder = fs::path(target).replace_extension();
  const std::string stem = folder.filename();
  const std::vector<fs::path> before = pieces_in(folder, stem);
  // Whose else they may be: ParaView numbers the files of a time series in the same way.
  if (!before.empty() && !fs::exists(target))
    return failure(fmt::format("its pieces would replace {}, which belongs to no {}",
                               (folder / before.front()).string(), target.filename().string()));
  std::error_code code;
  const fs::path kept = scratch.path() / "before";
  fs::create_directory(kept, code);
  const bool new_folder = !code && fs::create_directory(folder, code);
  Moves moves;
  moves.fail(code);
  for (const fs::path& piece : before) moves.move(folder / piece, kept / piece);
  for (const fs::path& piece : pieces_in(written, stem))
    moves.move(written / piece, folder / piece);
  moves.move(file, target);
  if (!moves.failure()) return ok();
  if (!moves.undo()) {
    scratch.leave();
    return failure(fmt::format("{}; what was there before is in {}", moves.failure().message(),
                               kept.string()));
  }
  if (new_folder) fs::remove(folder, code);
  return failure(moves.failure().message());
}

}  // namespace

Status write_vtm(const Output& output, const std::string& path, const WriteOptions& options) {
  const fs::path target(path);
  Result<ScratchFolder> scratch = ScratchFolder::beside(path);
  if (!scratch) return std::move(scratch).error();
  if (!write_blocks(output, options, scratch->path() / target.filename()))
    return Error{ErrorCode::cannot_write, fmt::format("cannot write {}", path), {}, {}};
  return put_into_place(*scratch, target);
}

}  // namespace cover
