// A region as its sides see it: corners between sides, and what is seen from them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers.hpp"
#include "cdt/cdt.hpp"
#include "cdt/triangulation.hpp"
#include "limits/angles/angle_range.hpp"

namespace cover {

/// The vertices that a constrained Delaunay triangulation joins to the vertex of a corner.
struct Sighted {
  std::uint32_t vertex = 0;
  double direction = 0;  ///< turned from the corner's first side, counter-clockwise, in radians
};

/// A corner of a region: between the side that leaves its vertex and the next one to the left.
struct RegionCorner {
  std::uint32_t vertex = 0;
  std::uint32_t first = 0;  ///< its Sighted ones: [first, last), the ends of both sides with them
  std::uint32_t last = 0;
  double angle = 0;          ///< between the sides, up to 2 pi
  std::uint32_t before = 0;  ///< the side that ends here
};

/// A directed side, with the region on its left.
struct RegionSide {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t triangle = 0;  ///< on its left
  Corner edge;                 ///< of the triangle
  std::uint32_t start = 0;     ///< the corner at a
  std::uint32_t end = 0;       ///< the corner at b
  double nu_opt = 0;           ///< pi minus the angle under which the best vertex sees it
  bool is_free = false;        ///< no vertex encroaches it, exactly, and it is not exempt
};

/// The angles under which the apex of the triangle on a side may see it, where all angles are in
/// `range`. A coupled mesh is the constrained Delaunay triangulation of its vertices: the apex sees
/// the side under no less than any vertex of the region does, and a free side under no more than
/// 90 degrees.
///
/// REQUIRES: no vertex sees the side under more than range.most; kAngleSlack is left to a mesh
AngleRange apex_range(const RegionSide& side, const AngleRange& range, Meshes meshes);

/// All sides and corners of one region.
class RegionView {
 public:
  /// REQUIRES: `cdt` is the constrained Delaunay triangulation of a region; its outer and its
  ///           locked edges are the sides. It outlives the view.
  /// Cost:     O(triangles)
  explicit RegionView(const Triangulation& cdt);

  /// Sides that are not free, whoever encroaches them.
  void exempt(std::span<const IndexPair> sides);

  [[nodiscard]] const Triangulation& cdt() const { return cdt_; }
  [[nodiscard]] std::span<const RegionSide> sides() const { return sides_; }
  [[nodiscard]] const RegionCorner& corner(std::uint32_t c) const { return corners_[c]; }
  [[nodiscard]] std::span<const Sighted> seen_from(const RegionCorner& c) const {
    return std::span(sighted_).subspan(c.first, c.last - c.first);
  }
  /// The corner at a vertex; kNone: it has none, or several.
  [[nodiscard]] std::uint32_t only_corner_of(std::uint32_t v) const { return corner_of_[v]; }
  /// No two points of the region are farther apart.
  [[nodiscard]] double diameter() const { return diameter_; }
  /// By how much the region's corners are beyond 180 degrees, in sum and in radians: 0 only where
  /// it is convex, exactly. Infinite if its boundary is not one loop through all of its vertices.
  [[nodiscard]] double bend() const { return bend_; }
  [[nodiscard]] Point point(std::uint32_t v) const { return cdt_.points[v]; }
  /// The side at edge `edge` of triangle `t`; kNone: that edge is no side.
  [[nodiscard]] std::uint32_t side_at(std::uint32_t t, Corner edge) const {
    return side_of_[3 * t + edge];
  }

 private:
  void find_sides();
  void find_corners();
  void walk_corner(std::uint32_t side);
  void find_bend();

  const Triangulation& cdt_;
  double diameter_ = 0;
  double bend_ = kInfinity;
  std::vector<RegionSide> sides_;
  std::vector<std::uint32_t> side_of_;    ///< by half-edge
  std::vector<RegionCorner> corners_;     ///< corner i begins with side i
  std::vector<std::uint32_t> corner_of_;  ///< by vertex
  std::vector<Sighted> sighted_;
};

}  // namespace cover
