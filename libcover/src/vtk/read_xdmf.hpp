// XDMF with all numbers in the XML, as write_xdmf() has it.
#pragma once

#include <string>

#include <cover/read_mesh.hpp>
#include <cover/result.hpp>

namespace cover {

/// Reads the grid `mesh` with its attributes MaterialID, RegionId and GroupID, and the grid `lines`
/// with LineID and Marker.
///
/// Errors: cannot_open, syntax, id_out_of_range, unsupported_format
Result<MeshFile> read_xdmf(const std::string& path);

}  // namespace cover
