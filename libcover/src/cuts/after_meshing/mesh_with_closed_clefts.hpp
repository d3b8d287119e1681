// Regions with clefts, meshed without them.
#pragma once

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "cuts/work.hpp"

namespace cover {

/// Where one triangle is obtuse for every other point of the input, or more, and half of these
/// points are corners of clefts, the clefts are closed to lines, what is left is meshed and cut
/// until it meets its target, and they are opened again. Few triangles are obtuse then, by little,
/// which thin_cuts() mends; its note tells what was cut.
///
/// ENSURES: without clefts, or where that cannot be, `work` is as it was
/// Errors:  those of meshing
Status mesh_with_closed_clefts(Work& work, const Options& options, const Callbacks& callbacks);

}  // namespace cover
