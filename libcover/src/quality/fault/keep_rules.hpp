// When a change of a mesh stays: the rules of the quality method side by side. They differ, because
// each sees something else: what is replaced, an excerpt, or the whole region.
//
//   who                              sees              rule
//   moves (moves/)                   what is replaced  improvement_of; remove: no larger excess
//   thinning (repair/thin_out)       what is replaced  kMostThinned
//   search (repair/search)           an excerpt        is_gain
//   kicks for cuts (repair/kicks)    an excerpt        is_kick_kept
//   cuts (cuts/.../cut_and_improve)  an excerpt        is_cut_kept
//   couplings (plan/optimise)        the whole region  is_kept_beside_couplings
//   plan (plan/candidate, Ranking)   the whole region  Order::is_better, below a ceiling
//
// Meshes of all regions in one are mended by another editor, with counts of bad triangles (MostBad
// in mend/repairs), and layers stay where the whole keeps its bound (judge in
// layers/layered_region).
#pragma once

#include "quality/fault/merit.hpp"
#include "quality/fault/standing.hpp"
#include "target/goal.hpp"

namespace cover {

/// Of an excess: what a change must win to be worth its time.
inline constexpr double kWorthwhileGain = 0.01;

/// Moves: the excess that a step on triangles with largest excess `worst` must stay below.
inline double improvement_of(double worst) { return (1 - kWorthwhileGain) * worst; }

/// Thinning: the largest excess that new triangles may have. All of them meet the goal.
inline constexpr double kMostThinned = 0;

/// Search: whether the change from `before` to `now` is one for the better, of couplings, of large
/// angles without harm to these, or of small ones without harm to both.
bool is_gain(const GoalStanding& now, const GoalStanding& before);

/// Kicks for cuts, which are for the largest angle, whatever is preferred.
bool is_kick_kept(const Merit& now, const Merit& before);

/// A cut: it takes no larger angle, and is worth a vertex on a segment, which stays for good.
///
/// REQUIRES: both merits are by `goal`
bool is_cut_kept(const Merit& now, const Merit& before, const Goal& goal);

/// The search between light and heavy couplings in a small mesh: none may be bought with an angle,
/// as what follows mends couplings for less.
bool is_kept_beside_couplings(const Merit& now, const Merit& before);

}  // namespace cover
