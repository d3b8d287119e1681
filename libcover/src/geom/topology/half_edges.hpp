// Who is on the other side of a triangle's edge, for triangles that come as bare index triples.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/none.hpp"
#include "base/team.hpp"

namespace cover {

/// Three vertex indices, counter-clockwise.
using IndexTriple = std::array<std::uint32_t, 3>;

/// The directed edges of a list of triangles. Half-edge 3 t + i belongs to triangle t and runs from
/// its vertex i to its vertex i + 1 (mod 3), with the triangle on its left.
class HalfEdges {
 public:
  /// REQUIRES: vertex indices below `vertices`; `triangles` outlives this object
  /// Cost:     O(vertices + triangles), 12 bytes per half-edge; 4 bytes more with several threads
  HalfEdges(std::size_t vertices, std::span<const IndexTriple> triangles, const Team& team = {});

  /// The half-edge from `a` to `b`, or kNone. If several triangles claim it: the first of them.
  [[nodiscard]] std::uint32_t find(std::uint32_t a, std::uint32_t b) const;
  /// The opposite half-edge, or kNone where no triangle lies on the other side.
  [[nodiscard]] std::uint32_t twin(std::uint32_t h) const { return find(target(h), source(h)); }

  /// All half-edges by their source, then their target, then their number: the one at place `k`.
  [[nodiscard]] std::uint32_t in_order(std::size_t k) const { return sorted_[k].half_edge; }
  /// The place there of the first that leaves `vertex`; of size() for one vertex beyond the last.
  [[nodiscard]] std::uint32_t first_leaving(std::size_t vertex) const { return first_[vertex]; }

  /// True if no two triangles have the same directed edge.
  [[nodiscard]] bool all_different(const Team& team = {}) const;

  [[nodiscard]] std::uint32_t source(std::uint32_t h) const { return triangles_[h / 3][h % 3]; }
  [[nodiscard]] std::uint32_t target(std::uint32_t h) const { return source(next(h)); }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(sorted_.size()); }

  /// The next half-edge of the same triangle.
  static constexpr std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  /// The previous half-edge of the same triangle.
  static constexpr std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

 private:
  struct Entry {
    std::uint32_t target;
    std::uint32_t half_edge;
  };

  void sort_all();
  void sort_by_spans(const Team& team);
  void sort_around(std::size_t vertex);

  std::span<const IndexTriple> triangles_;
  std::vector<std::uint32_t> first_;  ///< by source vertex, into sorted_
  std::vector<Entry> sorted_;         ///< by source vertex, then target, then half-edge
};

/// The opposite of every half-edge, numbered as in HalfEdges; kNone where there is no triangle on
/// the other side.
///
/// REQUIRES: no two triangles have the same directed edge
/// Cost:     O(triangles) and 4 bytes per half-edge, for the few edges that a vertex usually has;
///           at most O(n log n) and 16 bytes more; 4 bytes more with several threads
std::vector<std::uint32_t> opposite_half_edges(std::size_t vertices,
                                               std::span<const IndexTriple> triangles,
                                               const Team& team = {});

}  // namespace cover
