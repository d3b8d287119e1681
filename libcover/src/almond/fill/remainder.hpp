// What the almonds leave of a region.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "almond/chords.hpp"
#include "almond/fill/refine_large_angles.hpp"
#include "disks/filler.hpp"

namespace cover {

/// The remainder as a constrained Delaunay triangulation with vertices of its own: those of the
/// exterior and fixed chords, and isolated points.
struct Remainder {
  Triangulation cdt;
  std::vector<std::uint32_t> vertex;     ///< by vertex of `cdt`: the vertex of the chord layer
  std::vector<Chord> chords;             ///< the boundary, in vertices of `cdt`
  std::vector<std::uint32_t> arc_chord;  ///< by chord: the chord of the chord layer
  ChordEdges edges;                      ///< chords by triangle and edge
  std::vector<std::uint32_t> blamed;     ///< almonds whose chords are no such boundary
};

/// Triangulates the remainder. This is the topological ground truth: with exact predicates, either
/// the chords bound a domain that lies on their left, or what rounding broke is named.
///
/// ENSURES: where none is blamed the chords are the whole boundary of `cdt`; together with interior
///          chords that occur in both directions, remainder and almonds then bound each other
///          exactly. Of places where chords conflict, up to `most_conflicts` are named, of each
///          almond one.
/// Cost:    O(n log n), and O(n) for each conflict
Remainder find_remainder(const ChordLayer& layer, std::span<const Almond> almonds,
                         std::span<const std::uint32_t> isolated, std::size_t most_conflicts = 1);

/// The remainder where no side has an almond: the region itself, whose triangulation is at hand.
Remainder whole_region(const Triangulation& cdt, const ChordLayer& layer,
                       std::span<const Almond> almonds);

/// A connected part of a remainder as work for a filler.
struct RemainderPart {
  FillTask task;
  std::vector<std::uint32_t> vertex;  ///< by point of the task: vertex of the remainder
  std::vector<std::uint32_t> chord;   ///< by chord of the task: chord of the remainder
};

/// The part of the remainder that the triangles `members` make up; points that `known` excludes
/// (those from there on) were added by a fill and are left out.
RemainderPart part_of(const Remainder& remainder, std::span<const std::uint32_t> members,
                      std::size_t known);

/// The connected parts of a triangulation: the number of each triangle's part.
std::vector<std::uint32_t> connected_parts(const Triangulation& cdt);

}  // namespace cover
