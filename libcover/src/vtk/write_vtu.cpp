// The default format. What stands in the file, and in which order, follows from what its readers
// take: triangles only, the material first and as active scalars, no field data.
#include <cover/write_mesh.hpp>

#include <vtkNew.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "io/files/atomic_file.hpp"
#include "vtk/grid.hpp"
#include "vtk/quiet_vtk.hpp"

namespace cover {

Status write_vtu(const Output& output, const std::string& path, const WriteOptions& options) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return std::move(file).error();
  file->release();
  const QuietVtk quiet;
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(file->temporary_path().c_str());
  writer->SetInputData(grid_of(view_of(output, options)));
  set_encoding(writer);
  if (writer->Write() == 0) {
    return Error{ErrorCode::cannot_write, "cannot write " + path, {}, {}};
  }
  return file->commit();
}

}  // namespace cover
