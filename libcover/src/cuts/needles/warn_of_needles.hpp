// Triangles that only cuts made as sharp as they are.
#pragma once

#include <vector>

#include <cover/options.hpp>
#include <cover/report.hpp>

#include "cuts/work.hpp"

namespace cover {

/// Adds a warning with number, angle and place where triangles below a degree are far sharper than
/// any in the plain triangulations of their region and those beside it, before segments were cut:
/// the input forces none of them. Another one where, without sizes, two vertices of a region are
/// far nearer to each other than anything there was before. Not where there are layers.
///
/// REQUIRES: `work` is in step, and its meshes are measured
/// Cost:     O(n); O(n log n) where there may be something to tell
void warn_of_needles(const Work& work, const Options& options, std::vector<Note>& notes);

}  // namespace cover
