// The edges and places of a mesh that nobody has vouched for.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <cover/ids.hpp>
#include <cover/point.hpp>
#include <cover/triangle_soup.hpp>

#include "base/none.hpp"
#include "base/team.hpp"

namespace cover {

class HalfEdges;

/// How far off a segment a vertex may be that was put on it: what rounding does, where no
/// coordinate is larger than `scale`.
double offset_on_segment(double scale);

/// Directed edges and coordinates of a TriangleSoup, for look-ups. Triangles with an index out of
/// range, a corner twice or a coordinate that is not finite are set aside and have no edges.
class SoupEdges {
 public:
  /// A directed edge of a triangle, which lies on its left.
  struct Edge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t triangle;
  };

  /// REQUIRES: `soup` outlives this object
  /// Cost:     O(n log n)
  explicit SoupEdges(const TriangleSoup& soup, const Team& team = {});

  /// All edges, by `from`, then `to`, then triangle.
  [[nodiscard]] std::span<const Edge> all() const { return edges_; }
  /// The edges that leave a vertex.
  [[nodiscard]] std::span<const Edge> leaving(std::uint32_t vertex) const;
  /// Index in all() of the first edge between two vertices.
  [[nodiscard]] std::optional<std::size_t> find(std::uint32_t from, std::uint32_t to) const;

  /// By place in all(): the place of the first edge the other way round, kNone if there is none.
  [[nodiscard]] std::vector<std::uint32_t> twins(const Team& team = {}) const;

  /// What a way along a segment has on its sides, by the RegionIds that the mesh bears: the
  /// triangles on its left, and those on its right or none. Where segments are nearer to each other
  /// than rounding, this tells which edges are of which.
  struct Banks {
    std::int64_t left;
    std::optional<std::int64_t> right;

    static Banks of(RegionId left, RegionId right) {
      return {left.value(), right == kVoid ? std::nullopt : std::optional(right.value())};
    }
  };

  /// The edges that lead from one vertex to another along the straight line between them, one after
  /// the other; none if there is no such way. Their ends may be off the line by `offset`. With
  /// `outer`, they have no triangle on their other side. `barred`, by vertex: where no way leads
  /// through, such as points of a clean input, which lie inside no segment; so ways along segments
  /// that are nearer to each other than `offset` are told apart. A way that has `banks` on its
  /// sides is preferred; they vouch for nothing.
  [[nodiscard]] std::vector<std::size_t> along(std::uint32_t from, std::uint32_t to, double offset,
                                               const std::vector<bool>& barred, bool outer,
                                               const Banks& banks) const;

  /// Of along(), a way that has these banks; none where the mesh bears no RegionIds.
  [[nodiscard]] std::vector<std::size_t> along_between(std::uint32_t from, std::uint32_t to,
                                                       double offset,
                                                       const std::vector<bool>& barred, bool outer,
                                                       const Banks& banks) const;
  /// Whether an edge has these banks, by the RegionIds that the mesh bears.
  [[nodiscard]] bool lies_between(const Edge& edge, const Banks& banks) const;

  /// The triangles set aside.
  [[nodiscard]] std::span<const std::uint32_t> unusable() const { return unusable_; }

  /// The vertex of a triangle at exactly this place.
  [[nodiscard]] std::optional<std::uint32_t> vertex_at(Point p) const;
  /// Pairs of different vertices of triangles at the same place.
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> doubles(const Team& team = {}) const;

 private:
  /// What along() looks for.
  struct Way {
    std::uint32_t from;
    std::uint32_t to;
    double offset;
    const std::vector<bool>& barred;
    bool outer;
    const Banks* banks;  ///< nullptr: whatever lies there
  };

  void sort_edges(const HalfEdges& sorted, std::span<const std::uint32_t> number_of,
                  const Team& team);
  [[nodiscard]] std::vector<std::size_t> follow(const Way& way) const;
  [[nodiscard]] std::optional<std::size_t> next_of(const Way& way, std::uint32_t at) const;

  const TriangleSoup& soup_;
  std::vector<std::uint32_t> first_;  ///< by vertex, into edges_; and the end
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> unusable_;
  std::vector<std::uint32_t> by_place_;  ///< used vertices, by coordinates, then index
};

}  // namespace cover
