// Reading geometry in gmsh's own language (target cover::gmsh, built where gmsh's library is).
#pragma once

#include <string>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover {

/// Reads a plane gmsh model, `.geo`: gmsh's library understands the file and meshes its curves; the
/// pieces are the segments. A surface becomes a polygon whose material is its physical group, by
/// name or else by number; where there are physical surfaces, others are void. Curves in a
/// physical group are contacts of its name, and points in one stay.
///
/// A `.geo` is a program, which may read other files and run commands.
/// Errors:  cannot_open; syntax, with what gmsh said; unsupported_format where the model is not
///          plane or has neither curves nor surfaces
/// Threads: calls wait for each other, because gmsh has one state for the whole process. It must
///          not be in use elsewhere in the program.
Result<Input> read_geo(const std::string& path);

}  // namespace cover
