// Region and hole seeds in an input that has polygons too.
#pragma once

#include <vector>

#include <cover/input.hpp>
#include <cover/pslg.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

namespace cover {

/// Lets the seeds of `input` speak for the faces that they lie in, over the polygons that were
/// painted there: a region seed gives its face the material, the name and the size that it states
/// and leaves the rest as it is; a hole seed makes its face void. So a face between polygons, or
/// one that segments cut off, can have a material of its own.
///
/// REQUIRES: pslg.side_seeds is filled
/// Errors: those of apply_seeds.
/// Cost:   O(n log n).
Result<Pslg> place_seeds(const Input& input, Pslg pslg, std::vector<Note>& notes);

}  // namespace cover
