// Whether what is to be drawn is there.
#pragma once

#include <string>

#include <cover/picture.hpp>
#include <cover/result.hpp>

namespace cover {

/// Whether triangles, lines and periodic vertices have their points, and regions, materials, middle
/// nodes and the array called `color` are as many as the triangles or points. Points and middle
/// nodes must be finite.
///
/// Errors: id_out_of_range, non_finite_coordinate
Status check_picture(const PictureMesh& mesh, const std::string& color);

}  // namespace cover
