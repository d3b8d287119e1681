// See mutable_joined_mesh.hpp.
// Tested by tests/unit/cuts/after_meshing/mutable_joined_mesh_test.cpp.
#include "cuts/after_meshing/mutable_joined_mesh.hpp"

#include <algorithm>
#include <array>

#include "base/containers/order.hpp"
#include "cdt/cdt.hpp"
#include "cdt/triangulation.hpp"
#include "cuts/after_meshing/effort.hpp"
#include "cuts/hand_out_triangles.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/curves/arc.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "quality/fault/merit.hpp"
#include "region/triangulation_of.hpp"

namespace cover {
namespace {

/// The numbers of `points` in the order of their coordinates, which does not depend on that of the
/// input.
std::vector<std::uint32_t> order_by_place(std::span<const Point> points) {
  return sorted_numbers(points.size(),
                        [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
}

/// The Steiner vertices of all regions in the order of their coordinates.
class SteinerOrder {
 public:
  explicit SteinerOrder(std::span<const RegionMesh> meshes) {
    std::vector<Point> by_region;
    for (const RegionMesh& mesh : meshes) {
      before_.push_back(by_region.size());
      by_region.insert(by_region.end(), mesh.steiner.begin(), mesh.steiner.end());
    }
    const std::vector<std::uint32_t> order = order_by_place(by_region);
    points_ = in_order(by_region, order);
    place_ = places_in(order);
  }

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// Where a region's own vertex `k` stands among all.
  [[nodiscard]] std::uint32_t place_of(std::size_t region, std::size_t k) const {
    return place_[before_[region] + k];
  }

 private:
  std::vector<std::size_t> before_;  ///< by region: vertices of those before it
  std::vector<Point> points_;
  std::vector<std::uint32_t> place_;
};

IndexTriple from_the_lowest(IndexTriple triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

/// By side, of the region alone.
std::vector<SideLimit> side_limits_alone(const RegionBoundary& boundary) {
  const Triangulation cdt = triangulation_of(boundary);
  return side_limits(cdt, locate_sides(cdt, boundary.sides));
}

/// By segment: whether it may not be cut here, being periodic or the chord of an arc.
std::vector<std::uint8_t> bound_segments(const Pslg& pslg) {
  std::vector<std::uint8_t> is_bound(pslg.segments.size(), 0);
  for (const SegmentPair& pair : pslg.periodic)
    is_bound[pair.from.index()] = is_bound[pair.to.index()] = 1;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    if (circle_of(pslg, pslg.segments[s]) != nullptr) is_bound[s] = 1;
  }
  return is_bound;
}

/// In the plane, where rounding is that of the coordinates that are written.
bool is_obtuse(const std::array<Point, 3>& corners, const LocalFrame& frame) {
  const auto& [a, b, c] = corners;
  return bluntness_of(frame.restore(a), frame.restore(b), frame.restore(c)) == Blunt::yes;
}

}  // namespace

MutableJoinedMesh::MutableJoinedMesh(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
                                     std::span<const RegionMesh> meshes, const Goal& goal)
    : goal_(goal),
      by_place_(order_by_place(pslg.points)),
      frame_(in_order(pslg.points, by_place_)),
      points_(pslg.points.size()),
      first_steiner_(2 * points_),  // room for as many cuts
      is_bound_(bound_segments(pslg)) {
  const SteinerOrder steiner(meshes);
  std::vector<Point> points = frame_.points();
  points.resize(first_steiner_);
  for (const Point& p : steiner.points()) points.push_back(frame_.enter(p));
  const std::vector<std::uint32_t> place = places_in(by_place_);
  std::vector<IndexTriple> triangles;
  std::vector<Side> sides;
  for (std::uint32_t r = 0; r < meshes.size(); ++r) {
    const RegionBoundary& boundary = boundaries[r];
    const auto number = [&](std::uint32_t v) {
      return v < boundary.points.size() ? place[boundary.vertices[v].index()]
                                        : static_cast<std::uint32_t>(first_steiner_) +
                                              steiner.place_of(r, v - boundary.points.size());
    };
    for (const auto& [a, b, c] : meshes[r].triangles)
      triangles.push_back(from_the_lowest({number(a), number(b), number(c)}));
    const std::vector<SideLimit> limits = side_limits_alone(boundary);
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      const auto& [a, b] = boundary.sides[s];
      const auto segment = static_cast<std::uint32_t>(boundary.segments[s].index());
      sides.push_back({{number(a), number(b)}, r, segment, limits[s]});
    }
  }
  std::sort(triangles.begin(), triangles.end());
  std::sort(sides.begin(), sides.end(),
            [](const Side& x, const Side& y) { return x.ends < y.ends; });
  join(with_neighbours(std::move(points), triangles), sides);
}

void MutableJoinedMesh::join(const Triangulation& all, std::span<const Side> sides) {
  std::vector<IndexPair> pairs;
  std::vector<SideLimit> limits;
  for (const Side& side : sides) {
    pairs.push_back(side.ends);
    limits.push_back(side.limit);
    region_.push_back(side.region);
    segment_.push_back(side.segment);
  }
  const std::vector<EdgeRef> at = locate_sides(all, pairs);
  mesh_ = MutableMesh(all, static_cast<std::uint32_t>(first_steiner_), at, std::move(limits));
  mesh_.set_goal({goal_.large, goal_.small, goal_.weight * kLightWeight});
  for (const auto& [a, b] : pairs) {
    const auto other = std::lower_bound(pairs.begin(), pairs.end(), IndexPair{b, a});
    const bool is_there = other != pairs.end() && *other == IndexPair{b, a};
    const auto number = static_cast<std::uint32_t>(other - pairs.begin());
    partner_.push_back(is_there ? number : kNone);
    beyond_.push_back(is_there ? at[number].triangle : kNone);
  }
}

std::vector<std::uint32_t> MutableJoinedMesh::triangles_above() const {
  std::vector<std::pair<std::array<Point, 3>, std::uint32_t>> found;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (!is_above(mesh_, t, goal_)) continue;
    std::array<Point, 3> corners{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
    if (std::abs(goal_.large) < kSameCot && !is_obtuse(corners, frame_)) continue;
    std::sort(corners.begin(), corners.end());
    found.push_back({corners, t});
  }
  std::sort(found.begin(), found.end());
  std::vector<std::uint32_t> out;
  for (const auto& [corners, t] : found) out.push_back(t);
  return out;
}

std::vector<SegmentId> MutableJoinedMesh::segments_to_halve() const {
  std::vector<SegmentId> found;
  for (const std::uint32_t above : triangles_above()) {
    std::vector<std::pair<double, std::uint32_t>> sides;  // with their squared lengths
    for (const std::uint32_t t : triangles_around(mesh_, above, effort::cuts::kHalvedAround)) {
      for (const Corner i : kCorners) {
        const std::uint32_t n = mesh_.triangles[t].n[i];
        if (!is_side(n)) continue;
        const Vector along = mesh_.corner(t, i.previous()) - mesh_.corner(t, i.next());
        sides.emplace_back(squared_length(along), side_index(n));
      }
    }
    if (sides.empty()) continue;
    const double longest = std::max_element(sides.begin(), sides.end())->first;
    for (const auto& [squared, side] : sides) {
      if (squared >= effort::cuts::kHalvedToo * longest) found.push_back(SegmentId{segment_[side]});
    }
  }
  sort_unique(found);
  return found;
}

Excerpt MutableJoinedMesh::excerpt_around(std::uint32_t t, std::size_t triangles) const {
  const auto spare = static_cast<std::uint32_t>(points_ + cuts_);
  return {mesh_, t, triangles, beyond_, may_cut() ? spare : kNone};
}

std::vector<std::uint32_t> MutableJoinedMesh::put_back(Excerpt& excerpt,
                                                       const MutableMesh& improved,
                                                       std::uint32_t side) {
  has_changed_ = true;
  if (side != kNone) {
    const std::uint32_t s = side_index(excerpt.outside[side]), r = partner_[s];
    const std::uint32_t s2 = add_side(s, excerpt);
    if (r != kNone) {  // start of s beside end of r, and the other way round
      const std::uint32_t r2 = add_side(r, excerpt);
      partner_[s] = r2, partner_[r2] = s;
      partner_[r] = s2, partner_[s2] = r;
    }
    cut_points_.push_back({SegmentId{segment_[s]}, frame_.restore(improved.points[excerpt.spare])});
    ++cuts_;
  }
  std::vector<std::uint32_t> changed = excerpt.replace(mesh_, improved);
  for (const std::uint32_t t : changed) {
    for (const std::uint32_t n : mesh_.triangles[t].n) {
      if (is_side(n) && partner_[side_index(n)] != kNone) beyond_[partner_[side_index(n)]] = t;
    }
  }
  return changed;
}

/// A new side, like `parent`, for the whole and the excerpt.
std::uint32_t MutableJoinedMesh::add_side(std::uint32_t parent, Excerpt& excerpt) {
  const auto number = static_cast<std::uint32_t>(mesh_.sides.size());
  mesh_.sides.repeat(parent);
  mesh_.allowances.push_back(mesh_.allowances[parent]);
  excerpt.outside.push_back(kSideBit | number);
  region_.push_back(region_[parent]);
  segment_.push_back(segment_[parent]);
  partner_.push_back(kNone);
  beyond_.push_back(kNone);
  return number;
}

std::vector<SegmentCut> MutableJoinedMesh::segment_cuts(const Pslg& pslg) const {
  return along_segments(pslg, cut_points_).cuts;
}

bool MutableJoinedMesh::is_valid() const {
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (mesh_.is_hole(t)) continue;
    const Point a = frame_.restore(mesh_.corner(t, 0)), b = frame_.restore(mesh_.corner(t, 1)),
                c = frame_.restore(mesh_.corner(t, 2));
    if (orientation(a, b, c) != Sign::positive) return false;
  }
  return true;
}

void MutableJoinedMesh::separate(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
                                 std::vector<RegionMesh>& meshes) const {
  const std::vector<std::uint32_t> region = regions_of_triangles();
  JoinedMesh joined;
  for (const Point& p : mesh_.points) joined.points.push_back(frame_.restore(p));
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (mesh_.is_hole(t)) continue;
    joined.triangles.push_back(mesh_.triangles[t].v);
    joined.region.push_back(region[t]);
  }
  hand_out_triangles(joined, ids_of_vertices(pslg), boundaries, pslg.points.size(), meshes);
}

/// By vertex: its point of `pslg`, which has the cuts; kNone inside a region.
std::vector<std::uint32_t> MutableJoinedMesh::ids_of_vertices(const Pslg& pslg) const {
  std::vector<std::uint32_t> id(mesh_.points.size(), kNone);
  std::copy(by_place_.begin(), by_place_.end(), id.begin());
  std::vector<std::pair<Point, std::uint32_t>> added;
  for (std::size_t v = points_; v < pslg.points.size(); ++v)
    added.push_back({pslg.points[v], static_cast<std::uint32_t>(v)});
  std::sort(added.begin(), added.end());
  for (std::size_t v = points_; v < points_ + cuts_; ++v) {
    const std::pair wanted(frame_.restore(mesh_.points[v]), 0U);
    id[v] = std::lower_bound(added.begin(), added.end(), wanted)->second;
  }
  return id;
}

/// By triangle: the index of the region that it lies in.
std::vector<std::uint32_t> MutableJoinedMesh::regions_of_triangles() const {
  std::vector<std::uint32_t> region(mesh_.triangles.size(), kNone), stack;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (mesh_.is_hole(t)) continue;
    for (const Corner i : kCorners) {
      if (is_side(mesh_.triangles[t].n[i])) {
        region[t] = region_[side_index(mesh_.triangles[t].n[i])];
        stack.push_back(t);
      }
    }
  }
  while (!stack.empty()) {
    const std::uint32_t t = stack.back();
    stack.pop_back();
    for (const std::uint32_t n : mesh_.triangles[t].n) {
      if (is_side(n) || region[n] != kNone) continue;
      region[n] = region[t];
      stack.push_back(n);
    }
  }
  return region;
}

}  // namespace cover
