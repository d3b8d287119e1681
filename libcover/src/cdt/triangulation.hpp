// A triangulation as plain arrays: what the constrained Delaunay triangulation leaves and what
// every later stage walks on.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <cover/point.hpp>

#include "base/none.hpp"
#include "geom/topology/corner.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {

/// A counter-clockwise triangle. Edge i is the one opposite to corner i.
struct Triangle {
  std::array<std::uint32_t, 3> v{};                     ///< corners
  std::array<std::uint32_t, 3> n{kNone, kNone, kNone};  ///< across edge i; kNone: outside
  std::uint8_t locked = 0;                              ///< bit i: edge i is constrained

  [[nodiscard]] bool is_locked(Corner i) const { return (locked >> i & 1U) != 0; }
  void set_locked(Corner i, bool on) {
    locked = static_cast<std::uint8_t>((locked & ~(1U << i)) | ((on ? 1U : 0U) << i));
  }
  /// The corner index of vertex `w`.
  /// REQUIRES: w is a corner.
  [[nodiscard]] Corner corner_of(std::uint32_t w) const { return corner_with(v, w); }
  /// The edge index towards triangle `t`.
  /// REQUIRES: t is a neighbour.
  [[nodiscard]] Corner edge_to(std::uint32_t t) const { return corner_with(n, t); }
};

/// Triangles over points. Neighbours are mutual; locked edges are locked on both sides.
struct Triangulation {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

/// Bare triangles with their neighbours, and all edges locked.
Triangulation with_neighbours(std::vector<Point> points, std::span<const IndexTriple> triangles);

}  // namespace cover
