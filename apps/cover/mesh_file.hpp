// Reading the triangles of a mesh that a subcommand is given.
#pragma once

#include <string>

#include <spdlog/logger.h>

#include <cover/result.hpp>
#include <cover/verify.hpp>

namespace cover::app {

/// The triangles of a mesh, as .vtm or in any format of read_mesh(). Formats that have groups
/// instead of materials need the manifest beside the mesh; without it the numbers of the groups
/// count as materials. A warning tells where midpoints of second-order triangles were left out.
///
/// Errors: those of read_mesh() and read_output()
Result<TriangleSoup> read_triangles(const std::string& path, spdlog::logger& log);

}  // namespace cover::app
