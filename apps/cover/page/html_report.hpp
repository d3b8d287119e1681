// The report as one page to read: no scripts, nothing loaded from elsewhere.
#pragma once

#include <string>

#include <cover/output.hpp>
#include <cover/result.hpp>

namespace cover::app {

/// Writes the page: a verdict, key figures, pictures, close-ups of layers, arcs (where the mesh is
/// of second order) and periodic sides, regions, angles, box method, notes, times.
///
/// Errors: cannot_write
Status write_report_html(const Output& output, const std::string& path, int order = 1);

}  // namespace cover::app
