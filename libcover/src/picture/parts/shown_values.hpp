// What a picture shows by colour: an array of the mesh, or an expression of arrays.
#pragma once

#include <string>
#include <vector>

#include <cover/picture.hpp>
#include <cover/result.hpp>

namespace cover {

/// By triangle: the array called `shown`, or the formula that it is in names of arrays, x and y, as
/// Options::size_of has them. Some formats hold regions and materials otherwise than in arrays, and
/// many no angles. Of values at points, as the region of the triangle has them, and of formulas the
/// mean of three corners.
///
/// Errors: bad_option for what is neither; id_out_of_range where an array that is shown has not as
///         many values as there are triangles or points
/// REQUIRES: all else in `mesh` was checked
Result<std::vector<double>> shown_values(const PictureMesh& mesh, const std::string& shown);

}  // namespace cover
