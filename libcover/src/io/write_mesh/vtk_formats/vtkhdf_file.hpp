// VTK's format in HDF5 of a mesh that may be on the disk.
#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include <cover/regions.hpp>
#include <cover/report.hpp>

#include <cover/mesh_view.hpp>
#include "io/write_mesh/region_columns.hpp"
#include "io/write_mesh/vtk_formats/vtu_file.hpp"

namespace cover {

/// What stands in the file; all of it is referred to.
struct VtkHdfSource {
  const RegionTable& table;
  const Report& report;
  const MeshView& lines;  ///< its lines and named points alone are looked at
  VtuGrid grid;
  std::size_t nodes_each = 3;
  std::size_t input_vertices = 0;
};

/// Writes what write_vtkhdf() promises. `status` is asked when all is written: whether the numbers
/// were what they should be.
///
/// Errors: cannot_write, out_of_memory, cancelled; those of `status`
Status write_vtkhdf_file(const VtkHdfSource& source, const std::string& path,
                         const std::stop_token& stop, const std::function<Status()>& status);

/// The same file where whoever has regions writes what belongs to these: `write` does so by a plan,
/// which has neither vertices nor regions yet. A target that is no regular file is refused.
///
/// Errors: cannot_write, out_of_memory, cancelled; those of `write`
Status write_vtkhdf_columns(const VtkHdfSource& source, const std::string& path,
                            const std::stop_token& stop,
                            const std::function<Status(ColumnPlan)>& write);

}  // namespace cover
