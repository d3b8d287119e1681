// From a mesh to a drawing: what is shown where, in which colour.
#pragma once

#include <cover/picture.hpp>
#include <cover/result.hpp>

#include "picture/drawing.hpp"

namespace cover {

/// Lays out the picture: title, mesh with interfaces and contacts, marks, scale bar, legend.
///
/// Errors: bad_option, id_out_of_range
Result<Drawing> compose(const PictureMesh& mesh, const PictureOptions& options);

}  // namespace cover
