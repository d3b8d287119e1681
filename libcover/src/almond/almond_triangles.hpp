// The triangles of the almonds.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "almond/chords.hpp"

namespace cover {

/// Vertices that a fill put on the chords, by chord of the chord layer, from a to b.
struct SplitChords {
  std::vector<std::uint32_t> first;  ///< by chord, into `vertices`; one more at the end
  std::vector<std::uint32_t> vertices;

  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t chord) const {
    return std::span(vertices).subspan(first[chord], first[chord + 1] - first[chord]);
  }
};

/// Triangulates the almonds: with a long interior chord two fans over it, else a star around a
/// centre Q, which is added to `points`. Vertices on a chord are joined to the corner opposite to
/// it.
///
/// Every triangle keeps rule.nu, whatever vertices lie on exterior chords.
/// Returns the almonds with a triangle that is not counter-clockwise in exact arithmetic or does
/// not keep rule.nu.
/// Ref: mitchell_1993_covering, Theorems 4 and 5
std::vector<std::uint32_t> triangulate_almonds(
    std::span<const Almond> almonds, const ChordLayer& layer, const SplitChords& splits,
    const CutRule& rule, std::vector<Point>& points,
    std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace cover
