// A mesh and its parts in VTK's XML format.
#pragma once

#include <span>

#include <cover/mesh_view.hpp>
#include <cover/regions.hpp>

#include "io/write_mesh/vtu_file.hpp"

namespace cover {

/// All triangles, with the cell arrays that write_vtu() promises; refers to `view`.
VtuGrid whole_grid(const MeshView& view);

/// All triangles, with the cell arrays that write_vtu() promises.
void write_whole(const MeshView& view, const ByteSink& sink);

/// Some triangles, with the same arrays and the point array GlobalNodeId: the number of a point in
/// the whole mesh.
void write_triangles(const MeshView& view, std::span<const std::size_t> triangles,
                     const ByteSink& sink);

/// Some lines, with their left region on the left. Cell arrays LineID (InterfaceId), LeftRegion,
/// RightRegion, LineKind (0 interface, 1 outline, 2 slit, 3 contact), marker; point array
/// GlobalNodeId.
///
/// REQUIRES: each of them is on an interface
void write_lines(const MeshView& view, const RegionTable& table, std::span<const std::size_t> lines,
                 const ByteSink& sink);

}  // namespace cover
