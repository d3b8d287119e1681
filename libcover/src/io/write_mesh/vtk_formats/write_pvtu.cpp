// A grid in parts, one for each process of a solver. Pieces are files in a folder beside the
// target. Tested by tests/unit/io/write_mesh/vtk_formats/write_pvtu_test.cpp.
#include <cerrno>
#include <filesystem>
#include <optional>

#include <cover/write_mesh.hpp>

#include "io/files/piece_folder.hpp"
#include "io/write_mesh/check_format.hpp"
#include "io/write_mesh/partition.hpp"
#include "io/write_mesh/vtk_formats/vtu_parts.hpp"

namespace cover {

Status write_pvtu(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".pvtu", output, path, options); !status) return status;
  const Result<std::filesystem::path> target = end_of_links(path);
  if (!target) return target.error();
  std::error_code ignored;
  if (std::filesystem::is_directory(*target, ignored)) return cannot_write(path, EISDIR);
  Result<PieceFolder> folder = PieceFolder::open(*target, path, options.stop);
  if (!folder) return std::move(folder).error();
  const MeshView view = view_of(output, options);
  const auto count = static_cast<std::uint32_t>(options.parts);
  const Partition partition = partition_of(view, count);
  std::vector<std::string> files;
  std::string text;
  for (std::uint32_t part = 0; part < count; ++part) {
    std::optional<Result<std::string>> file;
    with_part_grid(view, partition, part, [&](const VtuGrid& grid) {
      file = folder->add([&](const ByteSink& sink) { write_vtu_bytes(grid, sink); });
      if (!*file) return;
      files.push_back(**file);
      if (part + 1 == count) text = pvtu_text(grid, files);
    });
    if (!*file) return std::move(*file).error();
  }
  return folder->commit(text);
}

}  // namespace cover
