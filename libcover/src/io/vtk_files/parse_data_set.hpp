// VTK's data sets from text in memory, without VTK: .vtu, .vtp, .vti and legacy .vtk.
#pragma once

#include <string>
#include <string_view>

#include <cover/result.hpp>

#include "io/vtk_files/data_set.hpp"

namespace cover {

/// A file in XML: a grid, a surface or an image, of one piece or more, in ASCII, base64 or as
/// appended data, compressed or not. Arrays with one number for each item are read; of others, the
/// names are kept. `text` must outlive the data set.
///
/// Errors: syntax, truncated, unsupported_format, where it announces more than
///         limits.hpp allows.
/// Cost:   O(bytes, and what they unfold to)
Result<DataSet> parse_vtk_xml(std::string_view text, const std::string& source);

/// A legacy file, ASCII or binary, of any version from 1.0 to 5.1: an unstructured grid, polygonal
/// data, structured points, a structured or a rectilinear grid. The rest as parse_vtk_xml().
Result<DataSet> parse_legacy_vtk(std::string_view text, const std::string& source);

}  // namespace cover
