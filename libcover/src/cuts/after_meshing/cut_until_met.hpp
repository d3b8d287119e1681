// Segments cut until every region meets the target.
#pragma once

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "cuts/work.hpp"

namespace cover {

/// When there is no other round. Where thin_cuts() mends what is left, few triangles are enough: it
/// takes fewer points.
enum class CutUntil { few_are_left, none_is_left };

/// With Options::split_interfaces and the quality method: while triangles are left above
/// Options::max_angle, changes the mesh around them and cuts segments there. The result with fewest
/// such triangles is kept. Does nothing without that option, for a hull, with layers, nor where
/// Options::couplings come first and are not cut for.
///
/// ENSURES: a note tells how many points were added
/// Errors:  cancelled, internal
/// Cost:    some milliseconds for each triangle that is left and, per round, the cost of meshing
///          the regions whose segments were cut
Status cut_until_met(Work& work, const Options& options, const Callbacks& callbacks,
                     CutUntil until = CutUntil::few_are_left);

}  // namespace cover
