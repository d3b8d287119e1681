// When a change of a mesh stays: the rules of the quality method side by side. They differ, because
// each sees something else: what is replaced, an excerpt, or the whole region. Who keeps what by
// which rule, also of the plan and of other methods, is a table in docs/quality_method.md, "What is
// kept".
#pragma once

#include "quality/fault/merit.hpp"
#include "quality/fault/tally.hpp"
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
bool is_gain(const Tally& now, const Tally& before);

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
