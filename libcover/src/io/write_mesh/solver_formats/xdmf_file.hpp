// XDMF with its numbers in HDF5, of a mesh that may be on the disk.
#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include <cover/mesh_view.hpp>
#include <cover/result.hpp>

#include "io/write_mesh/vtk_formats/vtu_parts.hpp"

namespace cover {

/// What stands in the files; all of it is referred to.
struct XdmfSource {
  /// Its lines, groups, attributes and fields alone are looked at, and with attributes the regions.
  const MeshView& view;
  std::size_t points = 0, triangles = 0;
  std::size_t nodes_each = 3;
  ArrayWriter places;                   ///< x and y of each point, Float64
  ArrayWriter nodes;                    ///< of each triangle, Int64
  ArrayWriter material, region, group;  ///< of each triangle, Int32
};

/// Writes X.h5 and then X.xdmf, which are both on the disk before the first of them appears.
/// `status` is asked when all is written: whether the numbers were what they should be.
///
/// Errors: cannot_write, out_of_memory, cancelled; those of `status`
Status write_xdmf_file(const XdmfSource& source, const std::string& path,
                       const std::stop_token& stop, const std::function<Status()>& status);

}  // namespace cover
