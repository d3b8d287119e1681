// The visits of the boundary of a domain to its vertices.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cdt/triangulation.hpp"
#include "disks/filler.hpp"
#include "disks/packing/disk.hpp"

namespace cover::disks {

/// Corner i of triangle t, as 3 t + i.
using TriangleCorner = Index;

/// A visit of the boundary to a vertex, or an isolated point.
struct Visit {
  Index vertex = kNone;
  Index chord_in = kNone;           ///< the chord that arrives; kNone: isolated
  std::vector<TriangleCorner> fan;  ///< the corners of triangles there, counter-clockwise

  [[nodiscard]] bool is_isolated() const { return chord_in == kNone; }
};

/// All visits of the boundary of a triangulated domain. Visit k, for k below the number of
/// chords, is where chord k leaves from; then come the isolated points.
///
/// A walk goes from a chord to the next one met when turning clockwise around the vertex through
/// the domain; so a vertex where the domain is pinched has several visits.
struct Visits {
  std::vector<Visit> all;
  std::vector<Index> at_corner;  ///< by TriangleCorner

  /// An edge of the triangulation between visits.
  struct Edge {
    Index u = 0, w = 0;  ///< visits
  };
  /// The edges inside the domain, each once.
  [[nodiscard]] std::vector<Edge> inner_edges(const Triangulation& cdt) const;
};

/// REQUIRES: the locked edges of `cdt` with a triangle on their left are the chords.
Visits find_visits(const Triangulation& cdt, std::span<const Chord> chords);

}  // namespace cover::disks
