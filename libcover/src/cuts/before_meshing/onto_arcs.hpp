// Cuts on chords, put on the arcs that these stand for.
#pragma once

#include <vector>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>

#include "cuts/cut_segments.hpp"
#include "cuts/look_budget.hpp"

namespace cover {

/// Moves the points of `cuts` from chords of arcs to the arcs, at the same shares of the way. Where
/// that would lead over a point, a seed or another segment, the points stay on the chord, which is
/// straight from then on (kStraightened), and so are its images.
///
/// REQUIRES: `cuts` in the order of segments; with their images, see PeriodicClasses
/// ENSURES:  no vertex and no seed lies between a chord and what comes in its place, and pieces
///           of arcs meet other segments at points only, by exact predicates; but for those that
///           chords met before
///           Nothing of this once `looks` are spent, which ends it.
/// Cost:     O(n log n), for each time that points have to stay, where a chord is cut; else O(cuts)
std::vector<SegmentCut> onto_arcs(Pslg& pslg, const RegionTable& table,
                                  std::vector<SegmentCut> cuts, LookBudget& looks);

/// Warns of segments that are straight although they were chords, see straighten().
void warn_of_straight_arcs(const Pslg& pslg, std::vector<Note>& notes);

}  // namespace cover
