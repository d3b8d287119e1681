// Meshes from the disk into files, without holding them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>
#include <cover/write_mesh.hpp>

#include <cover/mesh_view.hpp>
#include "io/write_mesh/mesh_spool.hpp"
#include "io/write_mesh/region_columns.hpp"

namespace cover {

/// A mesh on the disk with all that formats tell beside it.
struct SpooledMesh {
  const MeshSpool& spool;
  const RegionTable& table;
  const Report& report;
  std::size_t line_count = 0;  ///< at the most
  std::function<std::vector<LineEdge>()> lines;
  std::vector<NamedPoint> named;  ///< with their numbers in the mesh
  unsigned threads = 1;           ///< that may write
  /// Has the plan of a .vtkhdf carried out by whoever has regions that `spool` has not, while it
  /// calls `here`; empty: the spool has all of them.
  std::function<Status(const ColumnPlan& plan, const std::function<Status()>& here)> elsewhere{};
};

/// The formats that can be written so: .vtu, .vtkhdf, .msh, .xdmf with its numbers in HDF5.
bool can_write_spooled(const std::string& path, const WriteOptions& options);

/// Whether whoever has regions may write their parts: only .vtkhdf, and no device.
bool is_written_by_columns(const std::string& path);

/// Writes what write_mesh() writes of the same mesh, byte for byte. The room on the disk is looked
/// at first.
///
/// REQUIRES: can_write_spooled(path, options); options.order is 1; where mesh.elsewhere is set,
///           is_written_by_columns(path)
/// Errors:   cannot_write, cancelled, out_of_memory
/// Memory:   some 80 bytes for each line, and in .msh 16 for each point of the input
Status write_spooled(const SpooledMesh& mesh, const std::string& path, const WriteOptions& options);

}  // namespace cover
