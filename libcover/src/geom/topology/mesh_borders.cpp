// All sides of all cells are sorted by their ends, so that equal sides stand together: a side is
// inner where exactly two cells of one material claim it and no line runs along it. Cells joined by
// inner sides form a piece, found by union-find, and each piece gets one seed, inside its largest
// cell.
// Tested by tests/unit/geom/topology/mesh_borders_test.cpp.
#include "geom/topology/mesh_borders.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "base/containers/union_find.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

using Index = std::uint32_t;

/// A side of a cell, or a line of the mesh.
struct Side {
  Index low;
  Index high;
  bool is_line;  ///< cells sort before lines
  Index owner;   ///< cell or line
  friend auto operator<=>(const Side&, const Side&) = default;
  [[nodiscard]] bool same_ends(const Side& other) const {
    return low == other.low && high == other.high;
  }
};

class BorderFinder {
 public:
  explicit BorderFinder(const CellMesh& mesh) : mesh_(mesh), pieces_(mesh.cells()) {
    input_.source = mesh.source;
    input_.void_rule = mesh.cells() ? VoidRule::unseeded_faces : VoidRule::holes_only;
  }

  Input find() {
    unite_points();
    unite_cells();
    collect_sides();
    sort_out_sides();
    number_points();
    place_seeds();
    return std::move(input_);
  }

 private:
  [[nodiscard]] std::span<const Index> corners(Index cell) const {
    return {mesh_.corners.data() + mesh_.first[cell], mesh_.first[cell + 1] - mesh_.first[cell]};
  }

  /// `place_[i]`: the first of the points where point i lies.
  void unite_points() {
    const std::vector<Index> order = sorted_numbers(
        mesh_.points.size(), [&](Index i, Index j) { return mesh_.points[i] < mesh_.points[j]; });
    place_.resize(order.size());
    std::size_t united = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool again = k > 0 && mesh_.points[order[k]] == mesh_.points[order[k - 1]];
      place_[order[k]] = again ? place_[order[k - 1]] : order[k];
      united += again;
    }
    if (united > 0)
      input_.warnings.push_back(counted(united, "node") +
                                " at the place of another: taken as the same");
  }

  /// `cell_[i]`: false where an earlier cell has the same corners.
  void unite_cells() {
    sorted_ = mesh_.corners;
    for (Index& corner : sorted_) corner = place_[corner];
    const auto key = [&](Index c) {
      return std::span(sorted_).subspan(mesh_.first[c], mesh_.first[c + 1] - mesh_.first[c]);
    };
    for (Index c = 0; c < mesh_.cells(); ++c) std::sort(key(c).begin(), key(c).end());
    const auto compare = [&](Index c, Index d) {
      return std::lexicographical_compare_three_way(key(c).begin(), key(c).end(), key(d).begin(),
                                                    key(d).end());
    };
    const std::vector<Index> order =
        sorted_numbers(mesh_.cells(), [&](Index c, Index d) { return compare(c, d) < 0; });
    counts_.assign(mesh_.cells(), true);
    std::size_t repeated = 0;
    for (std::size_t k = 1; k < order.size(); ++k) {
      if (compare(order[k - 1], order[k]) != 0) continue;
      counts_[order[k]] = false;
      ++repeated;
    }
    if (repeated > 0)
      input_.warnings.push_back(counted(repeated, "cell") +
                                " given more than once: the first material counts");
  }

  void collect_sides() {
    const auto add = [&](Index a, Index b, Index owner, bool is_line) {
      a = place_[a];
      b = place_[b];
      if (a != b) sides_.push_back({std::min(a, b), std::max(a, b), is_line, owner});
    };
    for (Index c = 0; c < mesh_.cells(); ++c) {
      if (!counts_[c]) continue;
      const std::span<const Index> ring = corners(c);
      for (std::size_t k = 0; k < ring.size(); ++k)
        add(ring[k], ring[(k + 1) % ring.size()], c, false);
    }
    for (Index l = 0; l < mesh_.lines.size(); ++l) add(mesh_.lines[l].a, mesh_.lines[l].b, l, true);
    std::sort(sides_.begin(), sides_.end());
  }

  /// Joins cells over inner sides and makes segments of the others. A segment with several lines
  /// keeps them all, so that the next stage can see that they coincide.
  void sort_out_sides() {
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t end = i, cells = 0;
      for (; end < sides_.size() && sides_[end].same_ends(sides_[i]); ++end)
        cells += !sides_[end].is_line;
      const bool has_line = cells < end - i;
      const Side& side = sides_[i];
      if (!has_line && cells == 2 &&
          mesh_.material[side.owner] == mesh_.material[sides_[i + 1].owner]) {
        pieces_.unite(side.owner, sides_[i + 1].owner);
      } else if (!has_line) {
        input_.segments.push_back({side.low, side.high, 0, 0, 0, {}});
      }
      for (std::size_t k = i + cells; k < end; ++k) {
        const CellMesh::Line& line = mesh_.lines[sides_[k].owner];
        const bool repeated = k > i + cells && line.name == mesh_.lines[sides_[k - 1].owner].name;
        if (repeated) continue;
        input_.segments.push_back({side.low, side.high, line.marker, line.id, 0, line.name});
      }
      i = end;
    }
  }

  /// Keeps the points in use, in the order of the file.
  void number_points() {
    std::vector<bool> used(mesh_.points.size());
    for (const InputSegment& s : input_.segments) used[s.a] = used[s.b] = true;
    for (const Index p : mesh_.kept) used[place_[p]] = true;
    std::vector<Index> number(mesh_.points.size());
    for (Index p = 0; p < mesh_.points.size(); ++p) {
      if (!used[p]) continue;
      number[p] = static_cast<Index>(input_.points.size());
      input_.points.push_back(mesh_.points[p]);
      input_.point_ids.push_back(mesh_.point_ids[p]);
    }
    for (InputSegment& s : input_.segments) {
      s.a = number[s.a];
      s.b = number[s.b];
    }
    for (const PointName& name : mesh_.names)
      input_.point_names.push_back({number[place_[name.point]], name.name});
  }

  void place_seeds() {
    std::vector<double> largest(mesh_.cells());
    std::vector<Index> seed_of(mesh_.cells());
    for (Index c = 0; c < mesh_.cells(); ++c) {
      if (!counts_[c]) continue;
      const Index piece = pieces_.find(c);
      const auto [at, size] = point_inside(corners(c));
      if (piece == c) {  // the first cell of its piece
        seed_of[c] = static_cast<Index>(input_.seeds.size());
        RegionSeed seed;
        seed.material = mesh_.materials[mesh_.material[c]];
        seed.id = static_cast<long>(seed_of[c]);
        input_.seeds.push_back(std::move(seed));
      } else if (size <= largest[piece]) {
        continue;
      }
      largest[piece] = size;
      input_.seeds[seed_of[piece]].at = at;
    }
  }

  /// A point inside a simple polygon, and the doubled area of the triangle it was found in.
  ///
  /// At the smallest corner v the polygon is convex. Where no other corner lies in the triangle of
  /// v and its neighbours its centroid will do, else half the way from v to the corner in it that
  /// is farthest from the third side.
  [[nodiscard]] std::pair<Point, double> point_inside(std::span<const Index> ring) const {
    const auto at = [&](std::size_t k) { return mesh_.points[ring[k % ring.size()]]; };
    std::size_t v = 0;
    for (std::size_t k = 1; k < ring.size(); ++k)
      if (at(k) < at(v)) v = k;
    const Point tip = at(v), before = at(v + ring.size() - 1), after = at(v + 1);
    const double turn = cross(after - tip, before - tip);
    const double sign = turn < 0 ? -1 : 1;
    double farthest = 0;
    Point far = tip;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point p = at(k);
      const double depth = sign * cross(before - after, p - after);
      if (p != tip && p != before && p != after && depth > farthest &&
          sign * cross(after - tip, p - tip) > 0 && sign * cross(before - tip, p - tip) < 0) {
        farthest = depth;
        far = p;
      }
    }
    if (farthest > 0) return {midpoint(tip, far), farthest};
    const Vector sum = (before - tip) + (after - tip);
    return {tip + (1.0 / 3) * sum, std::abs(turn)};
  }

  const CellMesh& mesh_;
  Input input_;
  std::vector<Index> place_;
  std::vector<Index> sorted_;
  std::vector<bool> counts_;
  std::vector<Side> sides_;
  UnionFind pieces_;  ///< of cells
};

}  // namespace

void CellMesh::add_cell(const std::vector<std::uint32_t>& cell, std::uint32_t cell_material) {
  corners.insert(corners.end(), cell.begin(), cell.end());
  first.push_back(corners.size());
  material.push_back(cell_material);
}

Input borders_of(const CellMesh& mesh) { return BorderFinder(mesh).find(); }

}  // namespace cover
