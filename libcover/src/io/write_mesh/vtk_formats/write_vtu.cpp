// The default format. Tested by tests/unit/io/write_mesh/vtk_formats/write_vtu_test.cpp.
#include <cover/write_mesh.hpp>

#include "base/run_all.hpp"
#include "io/files/atomic_file.hpp"
#include "io/write_mesh/check_format.hpp"
#include "io/write_mesh/vtk_formats/vtu_parts.hpp"

namespace cover {

Status write_vtu(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".vtu", output, path, options); !status) return status;
  Result<AtomicFile> file = AtomicFile::create(path, options.stop);
  if (!file) return std::move(file).error();
  const MeshView view = view_of_triangles(output, options);
  with_team(output.report.threads, [&](const Team& team) {
    write_whole(
        view, [&](std::string_view bytes) { file->write(bytes); }, team);
  });
  return file->commit();
}

}  // namespace cover
