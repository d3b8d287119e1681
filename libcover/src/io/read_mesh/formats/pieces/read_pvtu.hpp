// The mesh that a .pvtu and its pieces hold.
#pragma once

#include <string>

#include <cover/read_mesh.hpp>
#include <cover/result.hpp>

namespace cover {

/// The mesh as it was before it was divided: vertices and triangles by their numbers in the whole,
/// without ghosts, and the arrays that all pieces have.
///
/// Errors: cannot_open, where a piece is missing; syntax, also where pieces do not tell these
///         numbers, or not all of the whole
Result<MeshFile> read_pvtu_mesh(const std::string& path);

}  // namespace cover
