// A cleft is two triangles of the constrained Delaunay triangulation: its walls are sides of both,
// and their common edge runs from the end of one wall to the other end of the other.
// Tested by tests/unit/cuts/clefts/find_clefts_test.cpp.
#include "cuts/clefts/find_clefts.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "cdt/sides.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"
#include "region/triangulation_of.hpp"

namespace cover {
namespace {

constexpr double kLong = 100;  ///< a wall, at least, in widths
constexpr double kRoom = 10;   ///< to the next segments, at least, in widths
constexpr double kMostSlant = 0.5;

/// A region's triangulation, with the side on each edge.
struct Sided {
  Triangulation cdt;
  std::vector<std::array<std::uint32_t, 3>> side;  ///< by triangle and edge; kNone: none
};

Sided sided(const RegionBoundary& boundary) {
  Sided out;
  out.cdt = triangulation_of(boundary);
  out.side.resize(out.cdt.triangles.size(), {kNone, kNone, kNone});
  const std::vector<EdgeRef> at = locate_sides(out.cdt, boundary.sides);
  for (std::uint32_t s = 0; s < at.size(); ++s) out.side[at[s].triangle][at[s].edge] = s;
  return out;
}

class Finder {
 public:
  Finder(const Pslg& pslg, const RegionTable& table, std::span<const RegionBoundary> boundaries)
      : pslg_(pslg),
        table_(table),
        height_(pslg.segments.size(), {kInfinity, kInfinity}),
        at_(pslg.points.size()) {
    for (std::uint32_t s = 0; s < pslg.segments.size(); ++s) {
      at_[pslg.segments[s].a.index()].push_back(s);
      at_[pslg.segments[s].b.index()].push_back(s);
    }
    std::vector<Cleft> all;
    for (const RegionBoundary& boundary : boundaries) look_at(boundary, all);
    std::vector<int> uses(pslg.points.size(), 0);
    for (const Cleft& cleft : all) {
      for (const Cleft::End& end : cleft.end)
        ++uses[end.corner[0].index()], ++uses[end.corner[1].index()];
    }
    for (Cleft& cleft : all) {
      const bool is_apart = std::all_of(cleft.end.begin(), cleft.end.end(), [&](const auto& end) {
        return uses[end.corner[0].index()] == 1 && uses[end.corner[1].index()] == 1;
      });
      if (is_apart && has_room(cleft)) found_.push_back(cleft);
    }
    std::sort(found_.begin(), found_.end(), [&](const Cleft& x, const Cleft& y) {
      return point(x.end[0].corner[0]) < point(y.end[0].corner[0]);
    });
  }

  [[nodiscard]] std::vector<Cleft> found() && { return std::move(found_); }

 private:
  [[nodiscard]] Point point(VertexId v) const { return pslg_.points[v.index()]; }

  void look_at(const RegionBoundary& boundary, std::vector<Cleft>& all) {
    const Sided sided_cdt = sided(boundary);
    const auto& [cdt, side] = sided_cdt;
    for (std::uint32_t t = 0; t < cdt.triangles.size(); ++t) {
      const Triangle& triangle = cdt.triangles[t];
      for (const Corner i : kCorners) {
        if (const std::uint32_t s = side[t][i]; s != kNone) {
          note_height(boundary, s, boundary.points[triangle.v[i]]);
          continue;
        }
        const std::uint32_t u = triangle.n[i];
        if (u == kNone || u < t) continue;
        const Corner j = cdt.triangles[u].edge_to(t);
        // Opposite walls, either way.
        const std::array next{side[t][i.next()], side[u][j.next()]};
        const std::array previous{side[t][i.previous()], side[u][j.previous()]};
        add(boundary, next, previous, all);
        add(boundary, previous, next, all);
      }
    }
  }

  /// How far the apex over a side is from it.
  void note_height(const RegionBoundary& boundary, std::uint32_t s, Point apex) {
    const Segment& segment = pslg_.segments[boundary.segments[s].index()];
    const Point a = point(segment.a), b = point(segment.b);
    const bool is_left = boundary.vertices[boundary.sides[s][0]] == segment.a;
    height_[boundary.segments[s].index()][is_left ? 0 : 1] = distance_to_line(apex, a, b);
  }

  /// `walls` and `across` are sides of the region; kNone: no side.
  void add(const RegionBoundary& boundary, std::array<std::uint32_t, 2> walls,
           std::array<std::uint32_t, 2> across, std::vector<Cleft>& all) const {
    if (walls[0] == kNone || walls[1] == kNone) return;
    Cleft cleft = between(boundary, walls);
    if (!is_narrow(cleft)) return;
    for (Cleft::End& end : cleft.end) look_beyond(boundary, across, end);
    if (cleft.behind[0] == kVoid && cleft.behind[1] == kVoid) return;
    // Without it there would be nothing left of the region.
    if (cleft.end[0].segment && cleft.end[1].segment) return;
    all.push_back(cleft);
  }

  /// What lies between two sides, narrow or not.
  [[nodiscard]] Cleft between(const RegionBoundary& boundary,
                              std::array<std::uint32_t, 2> walls) const {
    const auto corner = [&](std::size_t wall, std::size_t k) {
      return boundary.vertices[boundary.sides[walls[wall]][k]];
    };
    // With the region on their left the walls run against each other.
    const auto key = [&](std::size_t wall) {
      return std::minmax({point(corner(wall, 0)), point(corner(wall, 1))});
    };
    const std::size_t first = key(0) < key(1) ? 0 : 1;
    Cleft cleft;
    cleft.region = boundary.id;
    for (const std::size_t w : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t wall = w == 0 ? first : 1 - first;
      cleft.wall[w] = boundary.segments[walls[wall]];
      const SegmentSides& sides = table_.sides[cleft.wall[w].index()];
      const bool is_left = corner(wall, 0) == pslg_.segments[cleft.wall[w].index()].a;
      cleft.behind[w] = is_left ? sides.right : sides.left;
    }
    // The first wall is followed against its direction: the cleft lies on its right then.
    cleft.end[0].corner = {corner(first, 1), corner(1 - first, 0)};
    cleft.end[1].corner = {corner(first, 0), corner(1 - first, 1)};
    return cleft;
  }

  /// Whether its walls are far longer than they are apart, and its ends run nearly straight across.
  /// Notes how far from that they are.
  [[nodiscard]] bool is_narrow(Cleft& cleft) const {
    const auto along = [&](std::size_t wall) {
      return point(cleft.end[1].corner[wall]) - point(cleft.end[0].corner[wall]);
    };
    for (Cleft::End& end : cleft.end) {
      if (end.corner[0] == end.corner[1]) return false;
      const Vector over = point(end.corner[1]) - point(end.corner[0]);
      const double width = length(over);
      if (kLong * width > std::min(length(along(0)), length(along(1)))) return false;
      for (const std::size_t w : {std::size_t{0}, std::size_t{1}})
        end.slant = std::max(end.slant, std::abs(dot(over, along(w))) / (width * length(along(w))));
      if (end.slant > kMostSlant) return false;
    }
    return true;
  }

  /// Finds the segment across an end, and what lies there; `across` as in add().
  void look_beyond(const RegionBoundary& boundary, std::array<std::uint32_t, 2> across,
                   Cleft::End& end) const {
    end.beyond = boundary.id;
    for (const std::uint32_t s : across) {
      if (s == kNone) continue;
      const auto [from, to] = boundary.sides[s];
      const std::array<VertexId, 2> ends{boundary.vertices[from], boundary.vertices[to]};
      if (ends != std::array{end.corner[0], end.corner[1]} &&
          ends != std::array{end.corner[1], end.corner[0]})
        continue;
      end.segment = boundary.segments[s];
      const SegmentSides& sides = table_.sides[end.segment->index()];
      end.beyond = ends[0] == pslg_.segments[end.segment->index()].a ? sides.right : sides.left;
    }
  }

  /// Whether nothing is nearly as near as the walls are to each other; finds how near.
  bool has_room(Cleft& cleft) const {
    double behind = kInfinity;
    for (const std::size_t w : {std::size_t{0}, std::size_t{1}}) {
      const SegmentSides& sides = table_.sides[cleft.wall[w].index()];
      if (cleft.behind[w] == cleft.region && sides.left == sides.right) return false;
      if (cleft.behind[w] != kVoid)
        behind =
            std::min(behind, height_[cleft.wall[w].index()][cleft.behind[w] == sides.left ? 0 : 1]);
    }
    for (Cleft::End& end : cleft.end) {
      end.room = behind;
      for (const VertexId v : end.corner) {
        for (const std::uint32_t s : at_[v.index()]) {
          const SegmentId id{s};
          if (id == cleft.wall[0] || id == cleft.wall[1] || id == end.segment) continue;
          const Segment& segment = pslg_.segments[s];
          end.room = std::min(end.room, length(point(segment.b) - point(segment.a)));
        }
      }
      if (end.room < kRoom * length(point(end.corner[1]) - point(end.corner[0]))) return false;
    }
    return true;
  }

  const Pslg& pslg_;
  const RegionTable& table_;
  std::vector<std::array<double, 2>> height_;   ///< by segment: over its left and right side
  std::vector<std::vector<std::uint32_t>> at_;  ///< by vertex: segments
  std::vector<Cleft> found_;
};

}  // namespace

std::vector<Cleft> find_clefts(const Pslg& pslg, const RegionTable& table,
                               std::span<const RegionBoundary> boundaries) {
  return Finder(pslg, table, boundaries).found();
}

}  // namespace cover
