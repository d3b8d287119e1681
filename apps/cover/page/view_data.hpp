// The mesh inside of an HTML report: what apps/cover/page/mesh_view.js draws.
#pragma once

#include <string>

#include <cover/output.hpp>

namespace cover::app {

/// The mesh as JSON that can stand inside of a script element: arrays of whole numbers in base64,
/// at most 40 bytes per triangle, and a row per region. Of larger meshes than `most` triangles,
/// those nearest to the largest angle, and all lines.
///
/// REQUIRES: output.report has a line for each region
/// Cost: O(n log n)
std::string view_data(const Output& output, std::size_t most);

}  // namespace cover::app
