// Cutting walls at the ends of layered lines, so that layers run up to them.
#pragma once

#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/result.hpp>

namespace cover {

/// Where segments may be cut (Options::split_interfaces, box_method) and a layered line ends at
/// about a right angle with a segment, cuts that at the heights of the layers; a note tells how
/// many points were added.
///
/// Errors: as resolve_layers()
/// Cost:   O(n log n)
Status cut_for_layers(Prepared& prepared, const Options& options);

/// The same before segments are cut to sizes, which would leave too short pieces of walls for
/// layers: where these are counted, since others are as many as pieces of lines are long for.
Status cut_before_sizes(Prepared& prepared, const Options& options);

}  // namespace cover
