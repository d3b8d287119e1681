// Segments cut until the meshes of a box method have no negative coupling.
#pragma once

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "cuts/work.hpp"

namespace cover {

/// With Options::box_method: as long as sides have a negative coupling in the meshes, for the sake
/// of their angles, cuts these and meshes the regions beside them again. Edges inside that are not
/// Delaunay are flipped.
///
/// ENSURES: notes tell how many points were added, and a warning names what is left
/// Errors:  cancelled, internal
/// Cost:    per round, that of meshing the regions whose segments were cut
Status cut_negative_couplings(Work& work, const Options& options, const Callbacks& callbacks);

}  // namespace cover
