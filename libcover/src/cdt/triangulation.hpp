// A triangulation as plain arrays: what the constrained Delaunay triangulation leaves and what
// every later stage walks on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// No triangle.
inline constexpr std::uint32_t kNone = 0xffffffffU;

/// Index of the next corner, counter-clockwise.
constexpr int next3(int i) { return i == 2 ? 0 : i + 1; }
/// Index of the previous corner.
constexpr int prev3(int i) { return i == 0 ? 2 : i - 1; }

/// A counter-clockwise triangle. Edge i is the one opposite to corner i.
struct Triangle {
  std::array<std::uint32_t, 3> v{};                     ///< corners
  std::array<std::uint32_t, 3> n{kNone, kNone, kNone};  ///< across edge i; kNone: outside
  std::uint8_t locked = 0;                              ///< bit i: edge i is constrained

  [[nodiscard]] bool is_locked(int i) const { return (locked >> i & 1) != 0; }
  void set_locked(int i, bool on) {
    locked = static_cast<std::uint8_t>((locked & ~(1 << i)) | ((on ? 1 : 0) << i));
  }
  /// The corner index of vertex `w`.
  /// REQUIRES: w is a corner.
  [[nodiscard]] int corner_of(std::uint32_t w) const { return v[0] == w ? 0 : v[1] == w ? 1 : 2; }
  /// The edge index towards triangle `t`.
  /// REQUIRES: t is a neighbour.
  [[nodiscard]] int edge_to(std::uint32_t t) const { return n[0] == t ? 0 : n[1] == t ? 1 : 2; }
};

/// Triangles over points. Neighbours are mutual; locked edges are locked on both sides.
struct Triangulation {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

}  // namespace cover
