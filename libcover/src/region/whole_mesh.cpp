// As in verify/verify: counter-clockwise triangles cover a point as often as their edges wind
// around it; inner edges cancel, and what is left are the sides.
#include "region/whole_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <cover/text.hpp>

#include "geom/predicates.hpp"
#include "geom/topology/soup_edges.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// Sets a flag that others may set at the same time.
void set(std::uint8_t& flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); }

class Finder {
 public:
  Finder(const MeshOfRegion& mesh, const Team& team)
      : mesh_(mesh),
        team_(team),
        edges_(mesh.points.size(), mesh.triangles, team),
        is_side_(3 * mesh.triangles.size(), 0) {}

  std::optional<Flaw> find(std::vector<std::uint32_t>* across) {
    across_ = across;
    std::optional<Flaw> flaw = find_bad_triangle();
    if (!flaw) flaw = find_missing_side();
    if (!flaw) flaw = find_open_edge();
    if (!flaw) flaw = find_lost_point();
    return flaw;
  }

 private:
  [[nodiscard]] Point at(std::uint32_t v) const { return mesh_.points[v]; }

  static Flaw edge_flaw(Point a, Point b, const char* what) {
    return {"the edge from " + describe(a) + " to " + describe(b) + what, {a, b}, {}};
  }

  /// The first of the numbers below `count` for which `is_it` holds; `count` if there is none.
  template <class IsIt>
  [[nodiscard]] std::size_t find_first(std::size_t count, const IsIt& is_it) const {
    std::atomic<std::size_t> found = count;
    team_.each_range(count, kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last && first < found; ++k) {
        if (!is_it(k)) continue;
        std::size_t other = found;
        while (k < other && !found.compare_exchange_weak(other, k)) {
        }
        return;
      }
    });
    return found;
  }

  [[nodiscard]] std::optional<Flaw> find_bad_triangle() const {
    const auto& triangles = mesh_.triangles;
    if (triangles.empty()) return Flaw{"there are no triangles", {}, {}};
    const std::size_t bad = find_first(triangles.size(), [&](std::size_t t) {
      const auto& [a, b, c] = triangles[t];
      return orientation(at(a), at(b), at(c)) != Sign::positive;
    });
    if (bad != triangles.size()) {
      const auto& [a, b, c] = triangles[bad];
      return Flaw{"the triangle " + describe(at(a)) + ", " + describe(at(b)) + ", " +
                      describe(at(c)) + " is not counter-clockwise",
                  {at(a), at(b), at(c)},
                  {}};
    }
    if (edges_.all_different(team_)) return std::nullopt;
    return Flaw{"two triangles have the same edge", {}, {}};
  }

  /// Whole sides first, which are no pieces of others.
  std::optional<Flaw> find_missing_side() {
    std::vector<std::uint8_t> is_missing(mesh_.sides.size(), 0);
    team_.each_range(mesh_.sides.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t s = first; s < last; ++s) {
        const std::uint32_t h = edges_.find(mesh_.sides[s][0], mesh_.sides[s][1]);
        set(h == kNone ? is_missing[s] : is_side_[h]);
      }
    });
    for (auto missing = is_missing.begin();
         (missing = std::find(missing, is_missing.end(), 1)) != is_missing.end(); ++missing) {
      const auto s = static_cast<std::size_t>(missing - is_missing.begin());
      const auto& [a, b] = mesh_.sides[s];
      if (mesh_.segments[s] != kHullSide || !walk_hull(a, b))
        return edge_flaw(at(a), at(b), " is a side, and no edge of the triangles");
    }
    return std::nullopt;
  }

  /// Marks the pieces of a side of the hull; false if they do not lead from `a` to `b`, straight on
  /// but for rounding.
  bool walk_hull(std::uint32_t a, std::uint32_t b) {
    if (open_.empty()) collect_open_edges();
    const Vector along = at(b) - at(a);
    const double farthest = farthest_off_ * length(along);
    for (std::uint32_t v = a; v != b;) {
      auto piece = std::lower_bound(open_.begin(), open_.end(), OpenEdge{v, 0});
      while (piece != open_.end() && piece->from == v && is_side_[piece->half_edge] != 0) ++piece;
      if (piece == open_.end() || piece->from != v) return false;
      is_side_[piece->half_edge] = 1;
      const std::uint32_t last = std::exchange(v, edges_.target(piece->half_edge));
      if (v < mesh_.boundary_points && v != b) return false;
      if (dot(at(v) - at(last), along) <= 0) return false;
      if (v != b && std::abs(cross(along, at(v) - at(a))) > farthest) return false;
    }
    return true;
  }

  void collect_open_edges() {
    farthest_off_ = offset_on_segment(largest_coordinate(mesh_.points));
    for (std::uint32_t h = 0; h < edges_.size(); ++h) {
      const bool is_whole_side = std::binary_search(mesh_.sides.begin(), mesh_.sides.end(),
                                                    IndexPair{edges_.source(h), edges_.target(h)});
      if (!is_whole_side && edges_.twin(h) == kNone) open_.push_back({edges_.source(h), h});
    }
    std::sort(open_.begin(), open_.end());
  }

  [[nodiscard]] std::optional<Flaw> find_open_edge() const {
    if (across_ != nullptr) across_->resize(edges_.size());
    const auto is_open = [&](std::uint32_t h) {
      const std::uint32_t twin = edges_.twin(h);
      if (across_ != nullptr) (*across_)[h] = is_side_[h] == 0 ? twin : kNone;
      if (is_side_[h] == 0) return twin == kNone;
      // A slit has triangles on both sides, and is a side twice.
      return twin != kNone && is_side_[twin] == 0;
    };
    const std::size_t bad = find_first(
        edges_.size(), [&](std::size_t h) { return is_open(static_cast<std::uint32_t>(h)); });
    if (bad == edges_.size()) return std::nullopt;
    const auto h = static_cast<std::uint32_t>(bad);
    return edge_flaw(at(edges_.source(h)), at(edges_.target(h)),
                     is_side_[h] == 0 ? " has nothing on its other side, and is no side"
                                      : " is a side, and has triangles on both sides");
  }

  [[nodiscard]] std::optional<Flaw> find_lost_point() const {
    std::vector<std::uint8_t> used(mesh_.points.size(), 0);
    team_.each_range(mesh_.triangles.size(), kItemsAtATime,
                     [&](std::size_t first, std::size_t last) {
                       for (std::size_t t = first; t < last; ++t) {
                         for (const std::uint32_t v : mesh_.triangles[t]) set(used[v]);
                       }
                     });
    const auto end = used.begin() + static_cast<std::ptrdiff_t>(mesh_.boundary_points);
    const auto lost = std::find(used.begin(), end, 0);
    if (lost == end) return std::nullopt;
    const auto v = static_cast<std::uint32_t>(lost - used.begin());
    return Flaw{"the point " + describe(at(v)) + " is no vertex", {at(v)}, {v}};
  }

  struct OpenEdge {
    std::uint32_t from, half_edge;
    auto operator<=>(const OpenEdge&) const = default;
  };

  const MeshOfRegion& mesh_;
  const Team& team_;
  HalfEdges edges_;
  std::vector<std::uint8_t> is_side_;  ///< by half-edge
  std::vector<OpenEdge> open_;         ///< no triangle on the other side, no whole side
  std::vector<std::uint32_t>* across_ = nullptr;
  double farthest_off_ = 0;  ///< of a side of the hull, for points that split it
};

}  // namespace

std::optional<Flaw> find_flaw(const MeshOfRegion& mesh, const Team& team,
                              std::vector<std::uint32_t>* across) {
  return Finder(mesh, team).find(across);
}

std::optional<Flaw> find_flaw(const RegionBoundary& boundary, const RegionMesh& mesh) {
  return find_flaw({all_points(boundary, mesh), mesh.triangles, boundary.sides, boundary.segments,
                    boundary.points.size()});
}

}  // namespace cover
