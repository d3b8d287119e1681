// A mesh and its parts in VTK's XML format.
#pragma once

#include <array>
#include <functional>
#include <span>

#include <cover/mesh_view.hpp>
#include <cover/point.hpp>
#include <cover/regions.hpp>

#include "base/team.hpp"
#include "io/write_mesh/partition.hpp"
#include "io/write_mesh/vtk_formats/vtu_file.hpp"

namespace cover {

/// What triangles have beside their corners.
struct TriangleArrays {
  std::size_t triangles = 0;
  ArrayWriter material, region;   ///< Int32
  ArrayWriter largest, smallest;  ///< angles in degrees, Float64
};

/// The largest and the smallest angle of a triangle, in degrees.
std::array<double, 2> extreme_degrees(Point p, Point q, Point r);

/// Writes a point as VTK has it: three coordinates.
void put_place(Point place, BinaryWriter& out);

/// A grid of triangles with the cell arrays that write_vtu() promises. `coordinates` writes each
/// point by put_place(), `nodes` three Int64 for each triangle.
VtuGrid grid_of(const TriangleArrays& arrays, std::size_t points, ArrayWriter coordinates,
                ArrayWriter nodes);

/// All triangles, with the cell arrays that write_vtu() promises; refers to `view`.
VtuGrid whole_grid(const MeshView& view, const Team& team = {});

/// All triangles, with the cell arrays that write_vtu() promises.
void write_whole(const MeshView& view, const ByteSink& sink, const Team& team = {});

/// Some triangles, with the same arrays and the point array GlobalNodeId: the number of a point in
/// the whole mesh.
void write_triangles(const MeshView& view, std::span<const std::size_t> triangles,
                     const ByteSink& sink);

/// The triangles of a part and its ghosts, with the same arrays and for points and cells alike: ids
/// in the whole mesh (GlobalNodeId, GlobalCellId), owner (Owner, a part) and vtkGhostType. `use`
/// gets the grid, which is gone afterwards.
void with_part_grid(const MeshView& view, const Partition& partition, std::uint32_t part,
                    const std::function<void(const VtuGrid&)>& use);

/// Some lines, with their left region on the left. Cell arrays LineID (InterfaceId), LeftRegion,
/// RightRegion, LineKind (0 interface, 1 outline, 2 slit, 3 contact), marker; point array
/// GlobalNodeId.
///
/// REQUIRES: each of them is on an interface
void write_lines(const MeshView& view, const RegionTable& table, std::span<const std::size_t> lines,
                 const ByteSink& sink);

}  // namespace cover
