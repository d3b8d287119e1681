// Values at points out of files: for background sizes.
#pragma once

#include <string>
#include <string_view>

#include <cover/plane_field.hpp>
#include <cover/result.hpp>

namespace cover {

/// Reads the point arrays that have one component, and all plane cells as triangles, of .vtu, .vtp,
/// .vti, any legacy .vtk; or what .tif and .str of process simulators have; or a .csv, see
/// parse_csv_field().
///
/// Errors: cannot_open; unsupported_format; truncated; syntax
Result<PlaneField> read_plane_field(const std::string& path);

/// Lines of numbers x, y and one or more values, separated by commas or blanks, with `#` before
/// comments; a first line without numbers names the columns, else they are x, y, h. Triangles are
/// those of the points' Delaunay triangulation.
///
/// Errors: syntax, also for a place that has two values; truncated; non_finite_coordinate
/// Cost:   O(n log n)
Result<PlaneField> parse_csv_field(std::string_view text, const std::string& source);

}  // namespace cover
