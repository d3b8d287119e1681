// Reading background sizes from VTK's files, without VTK.
#pragma once

#include <string>

#include <cover/options.hpp>
#include <cover/result.hpp>
#include <cover/size_function.hpp>

namespace cover {

/// Reads edge lengths at points from .vtu, .vtp, .vti or any legacy .vtk, for size_function(): the
/// point array called "size" or "h", or the only one that has one component. Plane cells of any
/// kind are cut into triangles; other cells and z are passed over.
///
/// Errors: cannot_open; unsupported_format; truncated; syntax, also where there is no such array.
///         What it holds is looked at by size_function().
Result<SizeSamples> read_size_field(const std::string& path);

/// Makes Options::size_field of the file that Options::size_field_name names. Does nothing where
/// there is no name, or the function already.
///
/// Errors: those of read_size_field() and size_function()
Status load_size_field(Options& options);

}  // namespace cover
