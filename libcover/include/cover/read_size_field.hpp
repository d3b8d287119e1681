// Reading background sizes from VTK's files, without VTK, and from tables.
#pragma once

#include <string>

#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/result.hpp>
#include <cover/size_function.hpp>

namespace cover {

/// Reads edge lengths at points from .vtu, .vtp, .vti or any legacy .vtk, for size_function(): the
/// point array called "size" or "h", or the only one that has one component. Plane cells of any
/// kind are cut into triangles; other cells and z are passed over. Or from a .csv: lines x, y, h,
/// or a first line with the columns' names, of which size or h counts; points are joined by their
/// Delaunay triangulation.
///
/// Errors: cannot_open; unsupported_format; truncated; syntax, also where there is no such array.
///         What it holds is looked at by size_function().
Result<SizeSamples> read_size_field(const std::string& path);

/// Reads what sizes shall follow from the same files: `of` is as Options::size_of, the name of a
/// function, of the only array, or an expression of the arrays' names, x and y. Edges of the sizes
/// made change it by at most `step`: the size at a point is step over the steepest slope in the
/// triangles around it, less what edges of a mesh may be longer than asked. Where it is no number
/// nothing is asked.
///
/// REQUIRES: step > 0
/// Errors:   as the other; bad_option for an expression that cannot be read; syntax too for points
///           without triangles
Result<SizeSamples> read_size_field(const std::string& path, const std::string& of, double step);

/// Makes Options::size_field of the file that Options::size_field_name names, scaled by
/// Options::size_field_scale. Does nothing where there is no name, or the function already.
///
/// Errors: those of check_options(), read_size_field() and size_function()
Status load_size_field(Options& options);

/// The same for that input. If it was read from the same file, its scale is that of the sizes, too
/// (Options::size_field_scale). Else a warning tells that it was scaled alone, and where its points
/// and those of the file hardly meet, or one of both is more than a thousand times as large.
///
/// Errors: as the other
Status load_size_field(Options& options, Input& input);

}  // namespace cover
