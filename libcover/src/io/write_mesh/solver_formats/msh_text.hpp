// gmsh's format of a mesh that may be on the disk.
#pragma once

#include <string>

#include <cover/mesh_view.hpp>
#include "io/files/text_writer.hpp"
#include "io/write_mesh/cell_source.hpp"

namespace cover {

/// Writes what write_msh() promises. Of `view` only groups, lines, periodic sides, attributes and
/// fields are looked at; `version` is 2.2 or 4.1.
void write_msh_text(const MeshView& view, const CellSource& cells, const RegionTable& table,
                    const std::string& version, TextWriter& out);

/// Writes X_1.msh, X_2.msh, ..., which are all on the disk before the first of them appears.
///
/// REQUIRES: no periodic sides, which have no place in parts
/// Errors:   as write_msh()
Status write_msh_parts(const MeshView& view, const RegionTable& table, const std::string& path,
                       const WriteOptions& options);

}  // namespace cover
