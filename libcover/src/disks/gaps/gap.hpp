// Stage D: a gap, what is left between three or four touching sides, and its triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/packing.hpp>

#include "disks/packing/packing.hpp"

namespace cover::disks {

/// A gap. Its sides come counter-clockwise around it; t[k] is the vertex where side k touches side
/// k + 1.
struct Gap {
  int size = 0;  ///< 3 or 4
  std::array<Element, 4> e;
  std::array<Index, 4> t{};

  /// Where side k begins.
  [[nodiscard]] Index begin_of(int k) const {
    return t[static_cast<std::size_t>((k + size - 1) % size)];
  }
  [[nodiscard]] Index end_of(int k) const { return t[static_cast<std::size_t>(k)]; }
  /// The same gap, counted from side k on.
  [[nodiscard]] Gap from_side(int k) const;
};

/// The angles of a gap of four sides. Its four tangency points are cocircular.
struct GapAngles {
  Point centre;                   ///< of their circle
  std::array<double, 4> beta{};   ///< half the angle at `centre` over side k; the sum is pi
  std::array<double, 4> gamma{};  ///< half the angle of the arc of side k; the sum is pi
};

/// How far above 90 degrees an angle, in radians, still counts as right: arcs and chords that pass
/// through a centre up to rounding and snapping.
inline constexpr double kFlatGap = 1e-4;

/// The vertex where a fan around side k's chord has its foot, and the triangles of the fan: from
/// the chord p q of element `e` to the centre of `e` on the right (none if a line) and to the
/// vertex `centre` on the left. All have a right angle in the middle of p q, because both centres
/// are on the perpendicular bisector.
void fan(TriangleDraft& draft, const Element& e, Index p, Index q, Index centre);

GapAngles measure(const TriangleDraft& draft, const Gap& gap);

/// Three sides, at most one of them a line.
GapKind fill_three(TriangleDraft& draft, const Gap& gap);
/// Four sides, all angles at most right.
GapKind fill_good(TriangleDraft& draft, const Gap& gap, const GapAngles& angles);
/// Four sides, all arcs at most 180 degrees, beta[side] > pi / 2.
GapKind fill_by_cut(TriangleDraft& draft, const Gap& gap, const GapAngles& angles, int side);
/// Four sides, the arc of side 0 above 180 degrees.
GapKind fill_reflex(TriangleDraft& draft, const Gap& gap);
/// Four sides; 1 and 3 are lines.
GapKind fill_two_lines(TriangleDraft& draft, const Gap& gap);

/// Triangulates a gap; falls back to its cell where rounding spoils the construction.
GapKind fill_gap(TriangleDraft& draft, const Gap& gap, double tolerance);

/// The polygon of a gap: centres and tangency points, counter-clockwise.
std::vector<Index> cell_of(const Gap& gap);
/// Triangulates the polygon of a gap with the smallest possible largest angle.
void fill_cell(TriangleDraft& draft, const Gap& gap);

}  // namespace cover::disks
