// The default format. What stands in the file, and in which order, follows from what its readers
// take: triangles only, the material first and as active scalars, no field data.
#include <cover/write_mesh.hpp>

#include "io/atomic_file.hpp"
#include "vtk/grid.hpp"

namespace cover {

Status write_vtu(const Output& output, const std::string& path) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return std::move(file).error();
  file->release();
  if (Status status = write_grid(grid_of(output.mesh), file->temporary_path()); !status) {
    return status;
  }
  return file->commit();
}

}  // namespace cover
