// Delaunay refinement that attacks large angles only.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "base/team.hpp"
#include "cdt/triangulation.hpp"
#include "disks/filler.hpp"

namespace cover {

/// By triangle and edge: the chord that the edge is, or is a part of; kNone for inner edges.
using ChordEdges = std::vector<std::array<std::uint32_t, 3>>;

/// Finds the chord of every locked edge.
///
/// Returns the chords at fault: those that are no edge with the domain on their left, and those
/// whose edge has the domain on its right although no chord runs the other way, and those that end
/// where the boundary of `cdt` goes on without a chord. Empty: the chords are the boundary of
/// `cdt`, all of it and nothing else.
/// EXACT: yes
/// Cost:  O(triangles + chords)
std::vector<std::uint32_t> match_chords(const Triangulation& cdt, std::span<const Chord> chords,
                                        ChordEdges& edges);

/// Room for what refinement adds to most regions, an eighth of the vertices: vectors that grow take
/// twice what they hold. `points` and `triangles`: how many there will be before.
void reserve_for_refinement(std::size_t points, std::size_t triangles, Triangulation& cdt,
                            ChordEdges& edges);

/// What a refinement did.
struct Refinement {
  std::vector<ChordSplit> splits;  ///< by chord
  bool target_reached = false;
  std::vector<std::uint32_t> blocking;  ///< locked chords in the way of triangles below `keep_nu`
};

/// What a refinement aims at.
struct RefineGoal {
  double target_nu = 0;    ///< no angle is to be above pi - target_nu, or what its chords allow
  double keep_nu = 0;      ///< triangles that stay below this are blamed on locked chords
  std::size_t budget = 0;  ///< insertions
};

/// Inserts vertices until no angle is above what is aimed at, or the budget is used up.
///
/// A triangle with too large an angle gets its circumcentre. If a chord lies between, or would see
/// the circumcentre under 90 degrees or more, the chord is split instead: half way, or at a
/// distance that is a power of two from an end where it meets another chord sharply. Locked chords
/// stay whole.
///
/// REQUIRES: `cdt` is a constrained Delaunay triangulation whose chords are matched
/// ENSURES:  it still is, with new vertices at the end of its points; old triangles are replaced
/// EXACT:    topology by exact predicates
/// Ref:      Miller, Pav, Walkington 2003, with the largest angle as the only goal: a triangle
///           above 138.6 degrees has a ratio of circumradius to shortest edge at which Ruppert's
///           argument ends
Refinement refine_large_angles(Triangulation& cdt, ChordEdges& edges, std::span<const Chord> chords,
                               const RefineGoal& goal, const std::stop_token& stop,
                               const Team& team = {});

}  // namespace cover
