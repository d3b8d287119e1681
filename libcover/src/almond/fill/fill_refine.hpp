// The default fill: Delaunay refinement of large angles.
#pragma once

#include <cstddef>
#include <memory>
#include <numbers>

#include "disks/filler.hpp"

namespace cover {

/// No angle of the fill is to be above 145 degrees: below what the almonds leave, above the 138.6
/// degrees at which the argument for termination ends.
inline constexpr double kRefineTarget = std::numbers::pi * 35 / 180;

/// How many insertions are tried for a domain of `vertices` vertices: a hundred times what is
/// usual.
constexpr std::size_t refine_budget(std::size_t vertices) { return 20 * vertices + 1000; }

/// A filler that refines, with `factor` times the usual budget.
std::unique_ptr<Filler> make_refine_filler(std::size_t factor = 1);

}  // namespace cover
