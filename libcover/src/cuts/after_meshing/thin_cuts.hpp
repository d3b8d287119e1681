// Fewer vertices where no angle is obtuse.
#pragma once

#include <string>
#include <vector>

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "cuts/work.hpp"

namespace cover {

/// Whether thin_cuts() has something to do: segments may be cut, and 90 degrees are asked for.
/// Where sizes, layers, periodic sides or a hull ask for vertices too, none is taken away. Vertices
/// on arcs stay, and no others come to them.
bool wants_thinning(const Prepared& prepared, const std::vector<RegionBoundary>& boundaries,
                    const Options& options);

/// In all regions together.
std::size_t obtuse_triangles(const std::vector<RegionMesh>& meshes);

/// What would be worse in words; empty: nothing that makes up for no angle. More triangles would be
/// obtuse, with the box method more couplings negative, or promise 3 would not hold in a region any
/// longer.
std::string what_is_worse(const std::vector<RegionMesh>& before,
                          const std::vector<RegionMesh>& after, const Options& options);

/// Takes away, over segments too, vertices that no right angle needs, merges and moves others, and
/// mends obtuse triangles that are left. Points of the input stay. No more triangles are obtuse
/// than before. No smallest angle of a region becomes smaller than it was or than
/// Options::min_angle, but where a triangle in it or beside it was obtuse.
/// Where that cannot be, the mesh stays as it was.
///
/// ENSURES: a note tells how many went, or that none could
/// Errors:  cancelled, internal
/// Cost:    as Options::effort says, see docs/cutting_segments.md
Status thin_cuts(Work& work, const Options& options, const Callbacks& callbacks);

}  // namespace cover
