// Clefts are closed to lines, so that what is left has no narrow parts, and opened again.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cuts/clefts/find_clefts.hpp"
#include "cuts/work.hpp"
#include "mend/ease_mesh.hpp"
#include "mend/joined_mesh.hpp"

namespace cover {

/// A plane whose clefts are closed.
struct ClosedClefts {
  /// Not split yet. From each end of a cleft a slit goes on, at a right angle.
  Work work;
  std::vector<Cleft> clefts;
  /// By point of `work`, before any segment was cut: its number in the PSLG whose clefts were open.
  /// New points have numbers after those.
  std::vector<std::uint32_t> point_before;
  std::vector<Segment> segments;  ///< of `work`, before any was cut: whole; by those numbers
  /// By whole segment of `work`: its number in the PSLG whose clefts were open; kNone for slits.
  std::vector<std::uint32_t> segment_before;
  /// By cleft and end: the whole segment of `work` that is the slit; kNone if there is none.
  std::vector<std::array<std::uint32_t, 2>> slit;
  std::vector<std::uint32_t> wall;  ///< by cleft: the whole segment of `work`
};

/// A mesh whose clefts were opened.
struct OpenedClefts {
  JoinedMesh mesh;
  std::vector<FollowedVertex> pairs;  ///< cuts of a first wall and their feet on the other
};

/// Closes `clefts`: the other wall becomes the first one. Where an end is slanted, the wall is cut
/// so near to it that both triangles there can do without an obtuse angle.
///
/// REQUIRES: clefts of `whole`, whose segments are not cut, and at least one of them
/// Returns:  nothing if the plane would not be a sound one any more
std::optional<ClosedClefts> close_clefts(const Prepared& whole, std::span<const Cleft> clefts);

/// Opens them again: each triangle takes the corners of its side of the cleft, each cut of a wall
/// gets another one at its foot on the other wall, and triangles fill what is between.
///
/// REQUIRES: `mesh` is that of closed.work in one, whose points have the numbers they have there;
///           `whole` is what close_clefts() had
/// ENSURES:  points of `whole` have their numbers, others come after them
/// Returns:  nothing if feet are not in the order of the cuts, or beyond a wall, or if a triangle
///           turned over
std::optional<OpenedClefts> open_clefts(const JoinedMesh& mesh, const ClosedClefts& closed,
                                        const Prepared& whole);

}  // namespace cover
