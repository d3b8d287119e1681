// As in verify/verify: counter-clockwise triangles cover a point as often as their edges wind
// around it; inner edges cancel, and what is left are the sides.
#include "target/whole_mesh.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <cover/text.hpp>

#include "geom/predicates.hpp"

namespace cover {
namespace {

class Finder {
 public:
  explicit Finder(const MeshOfRegion& mesh)
      : mesh_(mesh),
        edges_(mesh.points.size(), mesh.triangles),
        is_side_(3 * mesh.triangles.size(), false) {}

  std::optional<BoundaryFault> find() {
    std::optional<BoundaryFault> fault = find_bad_triangle();
    if (!fault) fault = find_missing_side();
    if (!fault) fault = find_open_edge();
    if (!fault) fault = find_lost_point();
    return fault;
  }

 private:
  [[nodiscard]] Point at(std::uint32_t v) const { return mesh_.points[v]; }

  static BoundaryFault edge_fault(Point a, Point b, const char* what) {
    return {"the edge from " + describe(a) + " to " + describe(b) + what, {a, b}, {}};
  }

  [[nodiscard]] std::optional<BoundaryFault> find_bad_triangle() const {
    if (mesh_.triangles.empty()) return BoundaryFault{"there are no triangles", {}, {}};
    for (const auto& [a, b, c] : mesh_.triangles) {
      if (orientation(at(a), at(b), at(c)) == Sign::positive) continue;
      return BoundaryFault{"the triangle " + describe(at(a)) + ", " + describe(at(b)) + ", " +
                               describe(at(c)) + " is not counter-clockwise",
                           {at(a), at(b), at(c)},
                           {}};
    }
    if (edges_.all_different()) return std::nullopt;
    return BoundaryFault{"two triangles have the same edge", {}, {}};
  }

  std::optional<BoundaryFault> find_missing_side() {
    for (std::size_t s = 0; s < mesh_.sides.size(); ++s) {
      const auto& [a, b] = mesh_.sides[s];
      const std::uint32_t h = edges_.find(a, b);
      if (h != HalfEdges::kAbsent) {
        is_side_[h] = true;
      } else if (mesh_.segments[s] != kHullSide || !walk_hull(a, b)) {
        return edge_fault(at(a), at(b), " is a side, and no edge of the triangles");
      }
    }
    return std::nullopt;
  }

  /// Marks the pieces of a side of the hull; false if they do not lead from `a` to `b`.
  bool walk_hull(std::uint32_t a, std::uint32_t b) {
    if (open_.empty()) collect_open_edges();
    for (std::uint32_t v = a; v != b;) {
      auto piece = std::lower_bound(open_.begin(), open_.end(), OpenEdge{v, 0});
      while (piece != open_.end() && piece->from == v && is_side_[piece->half_edge]) ++piece;
      if (piece == open_.end() || piece->from != v) return false;
      is_side_[piece->half_edge] = true;
      v = edges_.target(piece->half_edge);
      if (v < mesh_.boundary_points && v != b) return false;
    }
    return true;
  }

  void collect_open_edges() {
    for (std::uint32_t h = 0; h < edges_.size(); ++h) {
      const bool is_whole_side = std::binary_search(mesh_.sides.begin(), mesh_.sides.end(),
                                                    IndexPair{edges_.source(h), edges_.target(h)});
      if (!is_whole_side && edges_.twin(h) == HalfEdges::kAbsent)
        open_.push_back({edges_.source(h), h});
    }
    std::sort(open_.begin(), open_.end());
  }

  [[nodiscard]] std::optional<BoundaryFault> find_open_edge() const {
    for (std::uint32_t h = 0; h < edges_.size(); ++h) {
      const Point a = at(edges_.source(h)), b = at(edges_.target(h));
      const std::uint32_t twin = edges_.twin(h);
      if (!is_side_[h]) {
        if (twin == HalfEdges::kAbsent)
          return edge_fault(a, b, " has nothing on its other side, and is no side");
        continue;
      }
      // A slit has triangles on both sides, and is a side twice.
      if (twin != HalfEdges::kAbsent && !is_side_[twin])
        return edge_fault(a, b, " is a side, and has triangles on both sides");
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<BoundaryFault> find_lost_point() const {
    std::vector<bool> used(mesh_.points.size(), false);
    for (const IndexTriple& t : mesh_.triangles) {
      for (const std::uint32_t v : t) used[v] = true;
    }
    for (std::uint32_t v = 0; v < mesh_.boundary_points; ++v) {
      if (!used[v])
        return BoundaryFault{"the point " + describe(at(v)) + " is no vertex", {at(v)}, {v}};
    }
    return std::nullopt;
  }

  struct OpenEdge {
    std::uint32_t from, half_edge;
    auto operator<=>(const OpenEdge&) const = default;
  };

  const MeshOfRegion& mesh_;
  HalfEdges edges_;
  std::vector<bool> is_side_;   ///< by half-edge
  std::vector<OpenEdge> open_;  ///< no triangle on the other side, no whole side
};

}  // namespace

std::optional<BoundaryFault> find_fault(const MeshOfRegion& mesh) { return Finder(mesh).find(); }

std::optional<BoundaryFault> find_fault(const RegionBoundary& boundary, const RegionMesh& mesh) {
  return find_fault({all_points(boundary, mesh), mesh.triangles, boundary.sides, boundary.segments,
                     boundary.points.size()});
}

}  // namespace cover
