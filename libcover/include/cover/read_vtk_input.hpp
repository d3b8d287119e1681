// Reading geometry from VTK's files, without VTK.
#pragma once

#include <string>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover {

/// Reads a plane mesh as geometry: the sides between cells of different material, and those with a
/// cell on one side only, become the segments. Lines stay, with their number as name and marker.
///
/// Material is the first cell array of whole numbers called material, MaterialID, mat_id,
/// gmsh:physical, medit:ref, CellEntityIds, RegionId, or much like that (MaterialIds, phase,
/// attribute, region), in whatever case; or the only such array there is. Cells may
/// be triangles, quadrangles, pixels, strips or polygons; of curved cells the corners are taken.
/// Errors: cannot_open, syntax, truncated, unsupported_format, non_finite_coordinate
/// Cost:   O(n log n)
Result<Input> read_vtk_input(const std::string& path);

}  // namespace cover
