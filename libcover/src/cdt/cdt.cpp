// CGAL's Constrained_Delaunay_triangulation_2 with exact predicates and double points.
// Points go in by CGAL's spatial sort, segments in a fixed mixture of their order; afterwards the
// faces asked for are copied into plain arrays, ordered by their first point and then as CGAL
// stores them, a function of the order of points and segments alone. The hull of very many points
// has a way of its own (cdt/divide); what that does not bear comes here.
// Tested by tests/unit/cdt/cdt_test.cpp.
#include "cdt/cdt.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>

#include "base/containers/give_back.hpp"
#include "cdt/divide.hpp"
#include "geom/predicates.hpp"
#include "geom/subdivision/rounds.hpp"

namespace cover {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;
using VertexHandle = Cdt::Vertex_handle;
using FaceHandle = Cdt::Face_handle;

bool strictly_between(Point a, Point p, Point b) {
  if (orientation(a, b, p) != Sign::zero) return false;
  return (std::min(a, b) < p) && (p < std::max(a, b));
}

/// The first segment that crosses segment `s`.
CdtConflict find_crossing(std::span<const Point> points, std::span<const IndexPair> segments,
                          std::uint32_t s) {
  const Point a = points[segments[s][0]], b = points[segments[s][1]];
  for (std::uint32_t k = 0; k < segments.size(); ++k) {
    const Point c = points[segments[k][0]], d = points[segments[k][1]];
    if (static_cast<int>(orientation(a, b, c)) * static_cast<int>(orientation(a, b, d)) < 0 &&
        static_cast<int>(orientation(c, d, a)) * static_cast<int>(orientation(c, d, b)) < 0) {
      return {CdtConflict::Kind::crossing, std::min(k, s), std::max(k, s)};
    }
  }
  return {CdtConflict::Kind::crossing, s, s};
}

/// The point inside segment `s`.
CdtConflict find_point_on(std::span<const Point> points, IndexPair segment, std::uint32_t s) {
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    if (strictly_between(points[segment[0]], points[k], points[segment[1]])) {
      return {CdtConflict::Kind::point_on_segment, k, s};
    }
  }
  return {CdtConflict::Kind::point_on_segment, segment[0], s};
}

class Builder {
 public:
  Builder(std::span<const Point> points, std::span<const IndexPair> segments)
      : points_(points), segments_(segments), degree_(points.size()) {
    for (const auto& [a, b] : segments) {
      ++degree_[a];
      ++degree_[b];
    }
  }

  /// Inserts everything; so many conflicts stop it. Long segments that all cross the same edges
  /// make insertion in a given order quadratic, in random order not (shewchuk_brown_2015).
  std::vector<CdtConflict> insert_all(std::size_t most_conflicts = 1) {
    insert_points();
    if (!conflicts_.empty()) return conflicts_;
    for (const std::uint32_t s : rounds(segments_.size())) {
      insert_segment(s);
      if (conflicts_.size() >= most_conflicts) break;
    }
    if (!conflicts_.empty()) return conflicts_;
    // Only now: faces that segments made have whatever their memory held.
    for (auto f = cdt_.all_faces_begin(); f != cdt_.all_faces_end(); ++f) f->info() = 0;
    return {};
  }

  /// Marks every finite face.
  void mark_hull() {
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f) f->info() = kInside;
  }

  /// Marks the finite faces that are reached from the left of a side without crossing a segment.
  /// (The outside is reached only if the sides bound no domain; whoever cannot know finds that a
  /// side has no triangle on its left, or one on its right.)
  void mark_left_of_sides() {
    if (cdt_.dimension() < 2) return;  // all points are collinear
    std::vector<FaceHandle> stack;
    const auto mark = [&](FaceHandle f) {
      if (f->info() == kInside || cdt_.is_infinite(f)) return;
      f->info() = kInside;
      stack.push_back(f);
    };
    for (const auto& [a, b] : segments_) {
      FaceHandle f;
      int i = 0;
      const auto [u, v] = by_degree(a, b);
      if (!cdt_.is_edge(u, v, f, i)) continue;
      if (f->vertex(Cdt::ccw(i)) != handles_[a]) f = f->neighbor(i);
      mark(f);
      while (!stack.empty()) {
        const FaceHandle g = stack.back();
        stack.pop_back();
        for (int k = 0; k < 3; ++k) {
          if (!g->is_constrained(k)) mark(g->neighbor(k));
        }
      }
    }
  }

  /// Copies the marked faces; to be called last. There is most memory in use here, so nothing else
  /// is held that may go.
  Triangulation copy_marked() {
    Triangulation out;
    give_back(handles_);
    give_back(degree_);
    // A counting sort; next[v] becomes the number of the next face with v as its first point.
    std::vector<std::uint32_t> next(points_.size() + 1, 0);
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f) {
      if (f->info() == kInside) ++next[first_point(f) + 1];
    }
    for (std::size_t v = 1; v < next.size(); ++v) next[v] += next[v - 1];
    out.triangles.resize(next.back());
    for (auto f = cdt_.all_faces_begin(); f != cdt_.all_faces_end(); ++f) {
      f->info() = f->info() == kInside ? next[first_point(f)]++ : kNone;
    }
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f) {
      if (f->info() == kNone) continue;
      Triangle& triangle = out.triangles[f->info()];
      for (const Corner i : kCorners) {
        const auto of_face = static_cast<int>(i);
        triangle.v[i] = f->vertex(of_face)->info();
        triangle.n[i] = f->neighbor(of_face)->info();
        triangle.set_locked(i, f->is_constrained(of_face));
      }
    }
    cdt_.clear();
    out.points.assign(points_.begin(), points_.end());
    return out;
  }

 private:
  static constexpr std::uint32_t kInside = 1;

  static std::uint32_t first_point(FaceHandle f) {
    return std::min({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }

  using Site = std::pair<Kernel::Point_2, std::uint32_t>;

  /// As long as all points are on one line, CGAL passes all of them for the next one. Where so many
  /// come first, one that is off their line is taken before them. False if there is none.
  static bool leave_first_line(std::vector<Site>& sites) {
    constexpr std::ptrdiff_t kMany = 100;
    if (static_cast<std::ptrdiff_t>(sites.size()) <= kMany) return true;
    const auto is_off = [&](const Site& site) {
      return CGAL::orientation(sites[0].first, sites[1].first, site.first) != CGAL::COLLINEAR;
    };
    const auto off = std::find_if(sites.begin() + 2, sites.end(), is_off);
    if (off == sites.end()) return sites[0].first == sites[1].first;
    if (off - sites.begin() > kMany) std::rotate(sites.begin() + 2, off, off + 1);
    return true;
  }

  /// What CGAL would find if all points are on one line, without triangles.
  void order_along_line(std::vector<Site>& sites) {
    std::sort(sites.begin(), sites.end());
    rank_.resize(sites.size());
    for (std::uint32_t k = 0; k < sites.size(); ++k) {
      rank_[sites[k].second] = k;
      if (k == 0 || sites[k].first != sites[k - 1].first) continue;
      conflicts_.push_back(
          {CdtConflict::Kind::duplicate_point, sites[k - 1].second, sites[k].second});
      return;
    }
  }

  void insert_points() {
    std::vector<Site> sites;  // and not indices alone: sorting these waits for memory
    sites.reserve(points_.size());
    for (const Point& p : points_) {
      sites.emplace_back(Kernel::Point_2(p.x, p.y), static_cast<std::uint32_t>(sites.size()));
    }
    using Map = CGAL::First_of_pair_property_map<Site>;
    CGAL::spatial_sort(sites.begin(), sites.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>());
    if (!leave_first_line(sites)) return order_along_line(sites);
    handles_.resize(points_.size());
    FaceHandle hint;
    for (const auto& [site, k] : sites) {
      const std::size_t before = cdt_.number_of_vertices();
      const VertexHandle v = cdt_.insert(site, hint);
      if (cdt_.number_of_vertices() == before) {
        conflicts_.push_back(
            {CdtConflict::Kind::duplicate_point, std::min(v->info(), k), std::max(v->info(), k)});
        return;
      }
      v->info() = k;
      handles_[k] = v;
      hint = v->face();
    }
  }

  /// The ends of a segment, the one with fewer segments first: CGAL turns around the first one, and
  /// the hub of a wheel would make that quadratic.
  [[nodiscard]] std::pair<VertexHandle, VertexHandle> by_degree(std::uint32_t a,
                                                                std::uint32_t b) const {
    if (degree_[b] < degree_[a]) std::swap(a, b);
    return {handles_[a], handles_[b]};
  }

  void insert_segment(std::uint32_t s) {
    if (!rank_.empty()) {
      const std::uint32_t i = rank_[segments_[s][0]], j = rank_[segments_[s][1]];
      if (std::max(i, j) - std::min(i, j) > 1)
        conflicts_.push_back(find_point_on(points_, segments_[s], s));
      return;
    }
    const auto [a, b] = by_degree(segments_[s][0], segments_[s][1]);
    FaceHandle f;
    int i = 0;
    if (cdt_.is_edge(a, b, f, i)) {
      // A Delaunay edge that becomes a constraint leaves the triangulation as it is. (CGAL's own
      // insertion takes longer for that, and throws if it is a constraint already.)
      f->set_constraint(i, true);
      // Where all points are collinear there is no face on either side.
      if (cdt_.dimension() == 2) f->neighbor(i)->set_constraint(cdt_.mirror_index(f, i), true);
      return;
    }
    try {
      cdt_.insert_constraint(a, b);
    } catch (const Cdt::Intersection_of_constraints_exception&) {
      conflicts_.push_back(find_crossing(points_, segments_, s));
      return;
    }
    if (!cdt_.is_edge(a, b)) conflicts_.push_back(find_point_on(points_, segments_[s], s));
  }

  std::span<const Point> points_;
  std::span<const IndexPair> segments_;
  std::vector<std::uint32_t> degree_;  ///< segments at each point
  Cdt cdt_;
  std::vector<VertexHandle> handles_;
  std::vector<std::uint32_t> rank_;  ///< of points along a line that has all of them, if many
  std::vector<CdtConflict> conflicts_;
};

/// Points from which on they are divided.
constexpr std::size_t kVeryMany = 50'000;

}  // namespace

CdtResult triangulate_hull(std::span<const Point> points, std::span<const IndexPair> segments,
                           const Team& team) {
  CdtResult result;
  if (points.size() >= kVeryMany) {
    if (auto divided = triangulate_divided(points, segments, team)) {
      result.triangulation = *std::move(divided);
      return result;
    }
  }
  Builder builder(points, segments);
  result.conflicts = builder.insert_all();
  if (!result.conflicts.empty()) return result;
  builder.mark_hull();
  result.triangulation = builder.copy_marked();
  return result;
}

CdtResult triangulate_domain(std::span<const Point> points, std::span<const IndexPair> sides,
                             std::size_t most_conflicts) {
  Builder builder(points, sides);
  CdtResult result;
  result.conflicts = builder.insert_all(most_conflicts);
  if (!result.conflicts.empty()) return result;
  builder.mark_left_of_sides();
  result.triangulation = builder.copy_marked();
  return result;
}

}  // namespace cover
