// The default fill: Delaunay refinement of large angles.
#pragma once

#include <cstddef>
#include <memory>

#include "base/numbers.hpp"
#include "disks/filler.hpp"

namespace cover {

/// No angle of the fill is to be above 145 degrees: below what the almonds leave, above the 138.6
/// degrees at which the argument for termination ends.
inline constexpr double kRefineTarget = 35 * kDegree;

/// A filler that refines, with `factor` times refine_budget().
std::unique_ptr<Filler> make_refine_filler(std::size_t factor = 1);

}  // namespace cover
