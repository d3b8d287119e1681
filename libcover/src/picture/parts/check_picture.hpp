// Whether what is to be drawn is there.
#pragma once

#include <cover/picture.hpp>
#include <cover/result.hpp>

namespace cover {

/// Whether triangles, lines and periodic vertices have their points, and regions, materials and
/// middle nodes are as many as the triangles. Points and middle nodes must be finite.
///
/// Errors: id_out_of_range, non_finite_coordinate
Status check_picture(const PictureMesh& mesh);

}  // namespace cover
