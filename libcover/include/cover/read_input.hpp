// Reading geometry files.
#pragma once

#include <string>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover {

/// Reads a geometry file; the format follows from its extension:
/// `.poly` (Triangle; points may be in the `.node` beside it).
///
/// Errors: cannot_open, syntax, truncated, id_out_of_range, non_finite_coordinate,
///         unsupported_format; messages name file and line.
Result<Input> read_input(const std::string& path);

/// Reads Triangle's .poly format.
Result<Input> read_poly(const std::string& path);

}  // namespace cover
