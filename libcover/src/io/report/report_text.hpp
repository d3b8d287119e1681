// The report of a run whose mesh may be on the disk.
#pragma once

#include <string>

#include <cover/mesh_counts.hpp>
#include <cover/output.hpp>
#include <cover/result.hpp>

namespace cover {

/// report_json() with these counts instead of those of the mesh.
std::string report_json(const Output& output, const MeshCounts& counts);

/// Writes what report_json() gives.
///
/// Errors: cannot_write
Status write_report_json(const Output& output, const MeshCounts& counts, const std::string& path);

}  // namespace cover
