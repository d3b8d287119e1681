// Wished edge lengths: from names in the options to vertices of regions.
#pragma once

#include <span>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

#include "region/region_boundary.hpp"

namespace cover {

/// Fills RegionBoundary::size and size_at from the sizes of the input's regions and Options::sizes.
///
/// A rule without a name holds everywhere; one with a name in named_regions(); a
/// rule `at` a name at the vertices of the interface or contact of that name, or at the point whose
/// id in the user's file the name is. The smallest of several wins.
/// Errors: bad_option for a name that nothing has; the message tells those that there are
Status resolve_sizes(const Pslg& pslg, const RegionTable& table, const Options& options,
                     std::span<RegionBoundary> boundaries);

/// Gives vertices of a region the size that is wished inside of a neighbour which has them, too, if
/// that is smaller: where sides are cut to sizes, those between the two are cut so finely, and the
/// other sides of the region are graded from there.
///
/// Cost: O(n)
void share_sizes(const Pslg& pslg, std::span<RegionBoundary> boundaries);

/// Makes RegionBoundary::size_function of its size_expressions: graded_function().
///
/// REQUIRES: it is empty
/// Errors:   bad_option for what is no expression of x and y, and for what falls to zero
Status read_expressions(RegionBoundary& boundary, const Options& options);

/// Adds a warning if segments are longer than the sizes wished along them: vertices are put on
/// none, so triangles beside them are larger than wished. Others if Options::method makes nothing
/// of sizes, and for expressions that are a size at no vertex. `may_be_cut` is whether
/// Options::split_interfaces would cut the segments.
void warn_of_sizes(const Pslg& pslg, const Options& options,
                   std::span<const RegionBoundary> boundaries, bool may_be_cut,
                   std::vector<Note>& notes);

}  // namespace cover
