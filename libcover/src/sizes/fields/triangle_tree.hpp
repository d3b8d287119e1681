// Where a place lies among triangles that somebody else made: which of them contain it, and which
// piece of their border is nearest.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <cover/point.hpp>

namespace cover {

using TreeEdges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The edges of triangles, the smaller index first, sorted; those of several triangles as often.
TreeEdges edges_of(std::span<const std::array<std::uint32_t, 3>> triangles);

/// Triangles and the edges on their border in R-trees.
/// REQUIRES: indices that are there
class TriangleTree {
 public:
  /// Without triangles, each point is a piece of the border for itself.
  /// Cost: O(n log n)
  TriangleTree(std::span<const Point> points,
               std::span<const std::array<std::uint32_t, 3>> triangles, const TreeEdges& edges);
  ~TriangleTree();
  TriangleTree(TriangleTree&&) noexcept;

  /// Of the triangles that contain `p`, inside or on an edge, the first; exact. Flat ones contain
  /// nothing.
  /// Cost: O(log n) typically, as below.
  [[nodiscard]] std::optional<std::uint32_t> first_at(Point p) const;
  /// All of them, in order.
  void all_at(Point p, std::vector<std::uint32_t>& found) const;
  /// The nearest piece of the border.
  /// REQUIRES: points
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> nearest_border(Point p) const;

 private:
  struct Trees;
  std::unique_ptr<const Trees> trees_;
};

/// The shares of b and c in a point of the triangle abc, linear.
/// REQUIRES: abc is not flat
std::array<double, 2> shares_in(const std::array<Point, 3>& abc, Point p);

}  // namespace cover
